//! The block `position_control`: the P controller of the CNC, or what a drive that controls the position gets.

pub(crate) mod advice;
pub(crate) mod check;
pub(crate) mod design;
mod diff;
pub(crate) mod notes;
mod saturation;

use super::part::{Part, Summary};
use super::values::Values;
use crate::axis::Axis;
use crate::blocks::designed::Designed;
use crate::number::digits;
use reference::position_control::{Coeffs, PositionControl};

impl Part for PositionControl {
    fn is_asked_for(axis: &Axis) -> bool {
        axis.control.position_control.is_some()
    }

    fn coefficients(designed: &Designed) -> Coeffs<f64> {
        designed.position_control
    }

    fn notes(designed: &Designed) -> Vec<(String, String)> {
        notes::notes(&designed.axis)
    }

    fn ranges(designed: &Designed) -> [f64; 2] {
        let v_max = designed.axis.ipc.v_max;
        [v_max / 16.0, v_max]
    }

    fn summary(designed: &Designed) -> Summary {
        let line = |of: &crate::axis::PositionControl| {
            let kv = if of.kv > 0 { format!(", Kv {}/s", digits(design::kv(of))) } else { String::new() };
            format!("position control {}{kv}", of.location.text())
        };
        Summary::line(designed.axis.control.position_control.as_ref().map(line))
    }

    fn values(designed: &Designed) -> Values {
        diff::values(&designed.axis)
    }
}
