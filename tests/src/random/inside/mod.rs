//! What runs inside the generated crates: engines compared, C and Structured Text printed, answers listed.
//!
//! These files belong to two crates, this one and the one that `kernel` makes: they use nothing of the others in here but
//! `rng`.

pub mod blocks;
pub mod defect;
pub mod emit;
pub mod facts;
pub mod gcc;
pub mod judge;
pub mod stimulus;
pub mod subject;
pub mod worker;
