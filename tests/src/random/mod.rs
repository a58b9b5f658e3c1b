//! Random programs of the portable subset, run by every engine: the Rust itself, the program after specialising and after
//! each pass, the emitted C and Rust, the emitted Structured Text.
//!
//! ```text
//! rng, choices                the source of chance; what is chosen from it, and can be given back
//! overwritten                 a value of which a bit was changed
//! syntax, types, visit        the syntax tree and what can be asked of it
//! generate                    the program that choices make
//! print                       its Rust text
//! coverage                    which constructs it has
//! batch                       many programs as crates of their own
//! compile, structured_text    their C and their Rust, their Structured Text
//! shrink                      from a program that differs to a small one that still does
//! campaign                    all of that, from a seed to a report
//! ```
//! What those crates do, and the source of chance, is the crate `inside`.

pub mod batch;
pub mod campaign;
pub mod choices;
pub mod compile;
pub mod coverage;
pub mod generate;
pub mod overwritten;
pub mod print;
pub mod shrink;
mod structured_text;
pub mod syntax;
pub mod types;
pub mod visit;

pub use inside::rng;
