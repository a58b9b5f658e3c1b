//! The block `feedforward`: what the interpolator plans, to the position controller or as additive commands to the drive.

pub(crate) mod advice;
pub(crate) mod check;
pub(crate) mod design;
mod diff;
pub(crate) mod notes;
mod summary;

use super::part::{Part, Summary};
use super::values::Values;
use crate::axis::Axis;
use crate::blocks::designed::Designed;
use reference::feedforward::{Coeffs, Feedforward};

impl Part for Feedforward {
    fn is_asked_for(axis: &Axis) -> bool {
        axis.control.feedforward.is_some()
    }

    fn coefficients(designed: &Designed) -> Coeffs<f64> {
        designed.feedforward
    }

    fn notes(designed: &Designed) -> Vec<(String, String)> {
        notes::notes(&designed.axis)
    }

    fn ranges(designed: &Designed) -> [f64; 2] {
        let (torque, v_max) = (largest_acceleration(&designed.feedforward), designed.axis.ipc.v_max);
        [torque.min(v_max) / 16.0, torque.max(v_max)]
    }

    fn summary(designed: &Designed) -> Summary {
        Summary::line(designed.axis.control.feedforward.as_ref().map(summary::line))
    }

    fn values(designed: &Designed) -> Values {
        diff::values(&designed.axis)
    }
}

/// The noise on an acceleration at which the additive torque is cut off; without one no bound.
fn largest_acceleration(coeffs: &Coeffs<f64>) -> f64 {
    let factor = coeffs.torque_acceleration.max(coeffs.torque_jerk) * coeffs.weight;
    if factor > 0.0 { (f64::from(coeffs.torque_range.highest) / factor).clamp(1e-6, 1e7) } else { 1e7 }
}
