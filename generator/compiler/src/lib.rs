//! From portable Rust and known coefficients to the program of one block. No parameter, no file and no axis is known here.
//!
//! ```text
//! specialise -> pass -> interp, dump, ranges
//!                    -> legalise -> print
//! ```
//! `program` is the data between the steps, `arithmetic` what folding and the interpreter agree on.
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler
#![forbid(unsafe_code)]
#![warn(unreachable_pub)] // what no other crate can see does not look as if it could

pub mod arithmetic;
mod dump;
pub mod interp;
pub mod legalise;
pub mod pass;
pub mod print;
pub mod program;
pub mod ranges;
pub mod specialise;
pub mod structure;

use portable::{Literal, Portable, Real};

/// The scalar that a real is.
pub fn leaf<R: Real>(value: R) -> Literal {
    portable::scalar(&value)
}

/// The scalars of a value, in the order of its type.
pub fn leaves<T: Portable>(value: &T) -> Vec<Literal> {
    let mut leaves = Vec::new();
    value.visit(&mut |literal| leaves.push(literal));
    leaves
}
