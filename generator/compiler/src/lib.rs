//! From portable Rust and known coefficients to the program of one block. No parameter, no file and no axis is known here.
//!
//! ```text
//! specialise -> pass -> interp, dump
//!                    -> legalise -> print
//! ```
//! `program` is the data between the steps, `arithmetic` what folding and the interpreter agree on.
#![forbid(unsafe_code)]

pub mod arithmetic;
pub mod dump;
pub mod interp;
mod leaves;
pub mod legalise;
pub mod pass;
pub mod print;
pub mod program;
pub mod specialise;

pub use leaves::{leaf, leaves};
