//! Portable Rust: the IR types as plain data, the real type, the intrinsics, and the macro that fills the IR.
//!
//! `#[portable]` on a struct, an enum or a function leaves the item unchanged and adds its description as a constant,
//! which rustc itself resolves. Nothing here depends on a target language or an algorithm.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)] // the emitted comments and the subset's rules come from here

extern crate self as portable;

mod block;
mod extreme;
mod intrinsic;
mod ir;
mod literal;
mod real;

pub use block::{Block, Brake, Enable, Off};
pub use extreme::{Extreme, peak};
pub use intrinsic::{
    from_i32, from_u32, in_range, nearest, nearly_half, note, overlaid, truncate, unsigned, with_numbers, within,
};
pub use ir::{
    Argument, Arm, Binary, Body, CodeBlock, Expr, Fn, Intrinsic, Mode, Param, Place, Projection, Statement, Unary,
};
pub use literal::{EnumDef, Field, Literal, Portable, StructDef, Ty, Variant, VariantDef, scalar};
pub use portable_macro::{copy, portable};
pub use real::{Real, RealKind, Wide, is_within_i32};
