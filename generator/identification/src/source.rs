//! The side of the spring on which a vibration enters: at the motor, where stages can act on it, or at the load. No
//! proposal.

use crate::peaks::{at, windowed};
use crate::{Complex64, magnitude};
use std::ops::Range;

/// Largest distance of q from 1 for a vibration that enters at the motor.
const NEAR: f64 = 0.25;

/// The place where a vibration enters.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Side {
    /// stages with the motor's velocity as input can damp it
    Motor,
    /// |S/S0| does not describe the remaining vibration of the load: no proposal
    Load,
}

/// `a_load`/`v_motor` at a frequency [Hz] in windows in which an axis drives: the cross spectrum divided by the spectrum of
/// `v_motor`. `None` if a window is outside the record, or if `v_motor` is 0 there.
#[must_use]
pub fn ratio(a_load: &[f64], v_motor: &[f64], windows: &[Range<usize>], cycle_time: f64, hz: f64) -> Option<Complex64> {
    let (mut cross, mut power) = (Complex64::from(0.0), 0.0);
    for window in windows {
        let line = |signal: &[f64]| Some(at(&windowed(signal.get(window.clone())?)?, cycle_time, hz));
        let (a, v) = (line(a_load)?, line(v_motor)?);
        cross += v.conj() * a;
        power += v.norm_sqr();
    }
    (power > 0.0).then(|| cross / power)
}

/// The side, from q = (`a_load`/`v_motor`, moving) / (`a_load`/`v_motor`, excited): the motor if |q - 1| < 0.25.
#[must_use]
pub fn side(moving: Complex64, excited: Complex64) -> Side {
    let q = moving / excited;
    if magnitude(q - 1.0) < NEAR { Side::Motor } else { Side::Load }
}
