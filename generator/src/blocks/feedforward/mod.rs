//! The block `feedforward`: planned quantities, to the position controller or as additive commands to the drive.

pub(crate) mod advice;
pub(crate) mod check;
pub(crate) mod design;
pub(crate) mod diff;
pub(crate) mod notes;

use super::{BlockKind, Design, Summary, effects::Effects};
use crate::{axis::Axis, blocks::designed::Designed};
use portable::Extreme;
use reference::feedforward::{Coeffs, Feedforward};

impl Design for Feedforward {
    type Single = f32;

    fn design(designed: &Designed) -> Coeffs<f64> {
        designed.feedforward
    }
}

impl BlockKind for Feedforward {
    fn is_asked_for(&self, axis: &Axis) -> bool {
        axis.control.feedforward.is_some()
    }

    fn short_name(&self) -> &'static str {
        "ff"
    }

    fn purpose(&self, designed: &Designed) -> String {
        let of = &designed.feedforward;
        let has = |sum: &reference::feedforward::Quantities| sum.velocity || sum.acceleration || sum.jerk;
        let outputs = [
            (has(&of.conventional), "v_feedforward to the position controller"),
            (has(&of.additive), "additive_velocity to the drive"),
            (has(&of.torque), "additive_torque to the drive"),
        ];
        let outputs: Vec<&str> = outputs.iter().filter(|(exists, _)| *exists).map(|(_, output)| *output).collect();
        format!(
            "Feedforward of the motion that the interpolator plans: {}. The first call already puts out full values, without a ramp. \
             While the block is not called, its outputs keep the values of an earlier motion: do not use them.",
            outputs.join(", ")
        )
    }

    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        notes::notes(&designed.axis)
    }

    fn ranges(&self, designed: &Designed) -> [f64; 2] {
        let (torque, v_max) = (largest_acceleration(&designed.feedforward), designed.axis.ipc.v_max);
        [torque.smaller(v_max) / 16.0, torque.larger(v_max)]
    }

    fn summary(&self, designed: &Designed) -> Summary {
        let control = &designed.axis.control;
        let lines = |of| [Some(diff::line(of)), diff::torque(of, control.is_rotary)].into_iter().flatten();
        Summary { lines: control.feedforward.as_ref().into_iter().flat_map(lines).collect(), ..Summary::default() }
    }

    fn effects(&self, designed: &Designed) -> Effects {
        diff::effects(&designed.axis)
    }
}

/// The acceleration, as noise in a self-test, at which the additive torque reaches its limit; 1e7 without a torque.
fn largest_acceleration(coeffs: &Coeffs<f64>) -> f64 {
    let factor = coeffs.torque_acceleration.larger(coeffs.torque_jerk) * coeffs.weight;
    if factor > 0.0 { (f64::from(coeffs.torque_range.highest) / factor).clamp(1e-6, 1e7) } else { 1e7 }
}
