//! What the test files share.
#![forbid(unsafe_code)]

pub mod accuracy;
pub mod cases;
pub mod engines;
pub mod environment;
pub mod exploration;
pub mod model;
pub mod pictures;
pub mod random;
pub mod sensitivity;
pub mod simulation;
pub mod subject;
pub mod two_mass;
