//! The block `position_control`: the P controller of the CNC, or the commands to a drive that controls the position.

pub(crate) mod advice;
pub(crate) mod check;
pub(crate) mod design;
pub(crate) mod diff;
mod gain;
pub(crate) mod notes;

use super::{BlockKind, Design, Summary, effects::Effects};
use crate::axis::{Axis, Location};
use crate::{blocks::designed::Designed, number::digits};
use reference::position_control::{Coeffs, PositionControl};

impl Design for PositionControl {
    type Single = f32;

    fn design(designed: &Designed) -> Coeffs<f64> {
        designed.position_control
    }
}

impl BlockKind for PositionControl {
    fn is_asked_for(&self, axis: &Axis) -> bool {
        axis.control.position_control.is_some()
    }

    fn short_name(&self) -> &'static str {
        "pc"
    }

    fn purpose(&self, designed: &Designed) -> String {
        let location = designed.position_control.location;
        let what = match location {
            Location::Cnc => "Position controller in the CNC: the velocity command of the drive, manipulated_variable.",
            Location::Drive => "Position command for a drive that controls the position: x_drive.",
            Location::Profidrive => "Control deviation for a PROFIdrive that controls the position: xerr.",
        };
        format!("{what} {}", from_the_first_call(location))
    }

    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        notes::notes(&designed.axis)
    }

    /// The terms of its sums.
    fn terms(&self, axis: &Axis) -> String {
        let of = design::coefficients(axis);
        format!("feedforward {} additive {} torque {} adds {}\n", of.feedforward, of.additive, of.torque, of.adds)
    }

    fn ranges(&self, designed: &Designed) -> [f64; 2] {
        let v_max = designed.axis.ipc.v_max;
        [v_max / 16.0, v_max]
    }

    fn summary(&self, designed: &Designed) -> Summary {
        let line = |of: &crate::axis::PositionControl| {
            let kv = if of.kv > 0 { format!(", Kv {}/s", digits(design::kv(of))) } else { String::new() };
            format!("position control {}{kv}", diff::place(of.location))
        };
        Summary { lines: designed.axis.control.position_control.iter().map(line).collect(), ..Summary::default() }
    }

    fn effects(&self, designed: &Designed) -> Effects {
        diff::effects(&designed.axis)
    }
}

/// What the first call does, and what the drive gets while there is none.
pub(super) fn from_the_first_call(location: Location) -> &'static str {
    match location {
        Location::Cnc => {
            "The first call already acts on the whole position lag, without a ramp. While the block is not called, the drive keeps the \
             last velocity command, with which the axis moves on."
        }
        Location::Drive => {
            "The first call already puts out the whole command, without a ramp from the position of the drive. While the block is not \
             called, the drive keeps its last commands."
        }
        Location::Profidrive => {
            "The first call already puts out the whole deviation, without a ramp. While the block is not called, the drive keeps the \
             last deviation, which is then wrong."
        }
    }
}
