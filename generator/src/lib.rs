//! From axis parameters to specialised blocks.
//!
//! ```text
//! read -> check -> design -> feasibility -> (compiler: specialise -> passes -> legalise -> verify -> print) -> render -> write
//! config  check    designed  feasibility     blocks                                             target     render    write
//! ```
//! `pipeline` leads to designed axes, `generate` from there to files.
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler
#![forbid(unsafe_code)]
#![warn(unreachable_pub)] // an item that no other crate can use must not look public

pub mod analysis;
pub mod apply;
pub mod axis;
// A new word or variant must be handled here.
#[deny(clippy::wildcard_enum_match_arm)]
pub mod blocks;
#[deny(clippy::wildcard_enum_match_arm)]
mod check;
pub mod codes;
mod commissioning;
pub mod config;
#[deny(clippy::wildcard_enum_match_arm)]
pub mod design;
pub mod diagnostics;
pub mod diff;
pub mod digest;
pub mod error_ids;
pub mod exercise;
mod feasibility;
pub mod generate;
pub mod import_export;
pub mod manifest;
pub mod number;
pub mod parameters;
pub mod params_of;
pub mod pipeline;
pub mod reference_page;
pub mod response_file;
#[deny(clippy::wildcard_enum_match_arm)]
mod rules;
mod saved;
pub mod schema;
pub mod set_change;
pub mod set_number;
pub mod summary;
pub mod target;
pub mod trace;
pub mod write;
mod xml;
