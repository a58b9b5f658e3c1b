//! Angles, velocities and their ways from one cycle to the next. No state and no request is known here.

use super::{Inputs, Parameters};

/// A turn [0.001 deg].
pub const TURN: f64 = 360_000.0;

/// Whether a velocity or an S word is a number that counts.
#[must_use]
pub fn is_velocity(v: f64) -> bool {
    (-1e15..=1e15).contains(&v)
}

/// Whether a position is a number that counts.
#[must_use]
pub fn is_position(x: f64) -> bool {
    (-7e14..=7e14).contains(&x)
}

/// 0 <= wrap(x) < 360 000.
#[must_use]
pub fn wrap(x: f64) -> f64 {
    let rest = x.rem_euclid(TURN);
    // The remainder of a small negative number rounds to the turn itself.
    if rest < TURN { rest } else { 0.0 }
}

/// -180 000 <= near(d) < 180 000.
#[must_use]
pub fn near(d: f64) -> f64 {
    wrap(d + TURN / 2.0) - TURN / 2.0
}

/// Towards a velocity by at most a step; nothing where the magnitude is not above it already.
#[must_use]
pub fn slower(v: f64, to: f64, step: f64) -> f64 {
    if v.abs() > to { v.signum() * (v.abs() - step).max(to) } else { v }
}

/// What the position and the velocity of a cycle are, from those of the cycle before.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    /// the velocity
    pub v: f64,
    /// the position; `None`: it goes on with the velocity
    pub x: Option<f64>,
}

impl Motion {
    /// The position on the circle.
    #[must_use]
    pub fn position(self, before: f64, p: &Parameters) -> f64 {
        wrap(self.x.unwrap_or(before + self.v * p.cycle))
    }
}

/// Weight of the feedforward that is active: in the drive, or in the CNC.
#[must_use]
pub fn weight(p: &Parameters, inputs: &Inputs) -> f64 {
    match p.feedforward {
        _ if !p.in_cnc => p.w,
        Some(weight) if inputs.feedforward_active => {
            weight * f64::from(inputs.feedforward_percentage.clamp(0, 100)) / 100.0
        }
        _ => 0.0,
    }
}

/// The velocity as process data, and whether it was cut off.
#[must_use]
pub fn velocity_command(p: &Parameters, v: f64) -> (i32, bool) {
    // Half away from zero.
    let rounded = (v * p.velocity_scale).round();
    let [lowest, highest] = p.velocity_range.map(f64::from);
    let cut = rounded.clamp(lowest, highest);
    #[expect(clippy::cast_possible_truncation, reason = "a whole number within the range of i32")]
    let data = cut as i32;
    (data, rounded < lowest || rounded > highest)
}
