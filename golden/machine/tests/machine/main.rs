//! The crate machine: how a mover moves, and what the simple drive does to a velocity.
#![forbid(unsafe_code)]

mod drive;
mod profile;
mod random_motion;
