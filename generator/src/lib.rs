//! From axis parameters to specialised blocks.
//!
//! ```text
//! read -> check -> design -> specialise -> passes -> print -> render -> write
//! config  check    design    specialise    pass      target   render    write
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
pub mod generate;
pub mod import_export;
pub mod meaning;
pub mod noise;
pub mod parameters;
pub mod reference_page;
pub mod render;
pub mod schema;
pub mod self_test;
pub mod target;
pub mod vector;
pub mod write;
