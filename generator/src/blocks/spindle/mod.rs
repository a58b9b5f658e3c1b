//! The block `spindle`: its rules, and what it will do in words.

pub(crate) mod advice;
pub(crate) mod check;
mod in_drive;
mod limits;
mod offered;
mod velocities;
pub(crate) mod words;
