//! The data of the block: coefficients, state, what the drive got last. No motion.

use crate::position_control::Location;
use crate::{axis, spindle};
use portable::{Real, portable};

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// changeover
    pub spindle: spindle::Coeffs<R>,
    /// feedforward, position control, improved position control
    pub axis: axis::Coeffs<R>,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// changeover
    pub spindle: spindle::State<R>,
    /// feedforward, position control, improved position control
    pub axis: axis::State<R>,
    /// position control in the CNC: the position lag of the last cycle with a closed loop, 0 after an open one [0.001 deg]
    pub lag_before: R,
    /// what the drive got last
    pub held: Command<R>,
}

/// The velocity for the drive, without v_add.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Command<R> {
    /// position control in the CNC: velocity of the drive's last command, without v_add; held while a sample is missing
    /// [0.001 deg/s]
    pub v_command: R,
    /// additive velocity of the feedforward in the drive's last command; held while a sample is missing [0.001 deg/s]
    pub v_additive: R,
}

/// Whether the CNC controls the position.
#[portable]
pub fn is_in_cnc<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.axis.position_control.location == Location::Cnc && !coeffs.spindle.only_velocity
}
