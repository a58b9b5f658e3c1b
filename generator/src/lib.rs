//! From axis parameters to specialised blocks.
#![forbid(unsafe_code)]

pub mod arithmetic;
pub mod axis;
pub mod block;
pub mod check;
pub mod codes;
pub mod config;
pub mod design;
pub mod diagnostics;
pub mod digest;
pub mod interp;
pub mod parameters;
pub mod pass;
pub mod program;
pub mod specialise;
pub mod render;
pub mod target;
