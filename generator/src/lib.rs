//! From axis parameters to specialised blocks.
//!
//! ```text
//! read -> check -> design -> (compiler: specialise -> passes -> legalise -> verify -> print) -> render -> write
//! config  check    design                                                            target    render    write
//! ```
//! `block` and `generate` are the drivers; `axis` and `program` are the data between the steps.
#![forbid(unsafe_code)]

pub mod axis;
pub mod block;
pub mod certificate;
pub mod check;
pub mod codes;
pub mod config;
pub mod design;
pub mod diagnostics;
pub mod digest;
pub mod exchange;
pub mod generate;
pub mod meaning;
mod noise;
pub mod parameters;
pub mod reference_page;
mod render;
pub mod schema;
pub mod self_test;
pub mod target;
pub mod vector;
pub mod write;
