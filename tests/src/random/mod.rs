//! Random programs of the portable subset, run by every engine: the Rust itself, the program after specialising and after
//! each pass, the emitted C, the emitted Structured Text.
//!
//! ```text
//! rng, choices                the source of chance; what is chosen from it, and can be given back
//! syntax, types, visit        the syntax tree and what can be asked of it
//! generate                    the program that choices make
//! print                       its Rust text
//! coverage                    which constructs it has
//! batch, kernel               many programs as crates of their own
//! compile, structured_text    their C, their Structured Text
//! inside                      what those crates do: engines compared, C and Structured Text printed, answers listed
//! shrink                      from a program that differs to a small one that still does
//! campaign                    all of that, from a seed to a report
//! ```

pub mod batch;
pub mod campaign;
pub mod choices;
pub mod compile;
pub mod coverage;
pub mod generate;
pub mod inside;
mod kernel;
pub mod print;
pub mod rng;
pub mod shrink;
mod structured_text;
pub mod syntax;
pub mod types;
pub mod visit;
