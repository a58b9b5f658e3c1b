//! What runs inside the crates of random programs: engines compared, C, Rust and Structured Text printed, answers listed.
//!
//! It needs the compiler as anyone would, and nothing of its front end, whose dependencies take a minute to build.
#![forbid(unsafe_code)]

pub mod blocks;
pub mod defect;
pub mod emit;
pub mod emit_rust;
pub mod facts;
pub mod gcc;
pub mod judge;
pub mod rng;
pub mod stimulus;
pub mod subject;
pub mod worker;
