//! The crate nc: what programs say, what is refused, and how a mover moves.
#![forbid(unsafe_code)]

mod garbage;
mod manual;
mod meaning;
mod profile;
mod random_motion;
mod refused;
mod support;
