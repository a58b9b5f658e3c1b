//! From portable Rust and known coefficients to the program of one block. No parameter, no file and no axis is known here.
//!
//! ```text
//! specialise -> pass -> interp, dump, ranges
//!                    -> legalise -> print
//! ```
//! `program` is the data between the steps, `arithmetic` the common part of folding and the interpreter.
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler
#![forbid(unsafe_code)]
#![warn(unreachable_pub)] // an item that no other crate can use must not look public

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

/// A real as a scalar literal.
pub fn leaf<R: Real>(value: R) -> Literal {
    portable::scalar(&value)
}

/// The scalars of a value, in the order of its type.
pub fn leaves<T: Portable>(value: &T) -> Vec<Literal> {
    let mut leaves = Vec::new();
    value.visit(&mut |literal| leaves.push(literal));
    leaves
}
