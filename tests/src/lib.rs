//! What the test files share.
#![forbid(unsafe_code)]

pub mod cases;
pub mod environment;
pub mod pictures;
pub mod random;
pub mod simulation;
