//! Simulated machines: their motion, its causes, and measurements. The crate knows no parameter, no file and no block: a
//! block is a closure of the caller.
//!
//! ```text
//! machine        the interface: a velocity command in, measured values out, once per cycle
//! line           delays by whole cycles and by fractions; velocity: response of a velocity to its command
//! drive          an axis without mechanics: a delay, a time constant
//! mechanics      masses, springs, the mesh of rack and pinion, the current loop; plant: with a velocity loop, the
//! demonstration plant
//! two_masses     a motor and a load, with less arithmetic than the plant
//! velocity_loop  three exact velocity loops of a known equivalent time constant
//! profile        jerk-limited moves from any state; seven_phases: one from rest to rest by its formula; sequence: forward
//! and back
//! closed_loop    moves, a position controller, a machine, and improved position control as a closure: a record
//! measure        a record -> amplitudes, ring-down, following error
//! grid           numbers as in controllers
//! spindle        a spindle's drive, the operation mode that it displays, its interpolator and operator
//! ```
//!
//! Sines and powers come from libm: equal bits on every host. Times are in seconds; lengths and angles are in the unit of
//! the caller, except where a unit is given.
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler
#![forbid(unsafe_code)]

pub mod closed_loop;
pub mod drive;
pub mod grid;
pub mod line;
mod machine;
pub mod measure;
pub mod mechanics;
pub mod plant;
pub mod profile;
pub mod sequence;
pub mod seven_phases;
pub mod spindle;
pub mod two_masses;
pub mod velocity;
pub mod velocity_loop;

pub use machine::{Machine, Measured};
