//! The block `spindle_axis`: the changeover with feedforward, position control and improved position control.

use super::{Drill, Part, Summary};
use crate::blocks::designed::Designed;
use reference::axis::Axis;
use reference::spindle::Spindle;
use reference::spindle_axis::{Coeffs, SpindleAxis};

impl Part for SpindleAxis {
    fn is_asked_for(&self, axis: &crate::axis::Axis) -> bool {
        axis.control.spindle.is_some()
    }

    fn design(designed: &Designed) -> Coeffs<f64> {
        Coeffs { spindle: designed.spindle, axis: Axis::design(designed) }
    }

    /// Those of its parts.
    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        let within = |part: &'static str, notes: Vec<(String, String)>| {
            notes.into_iter().map(move |(path, text)| (format!("{part}.{path}"), text))
        };
        within("spindle", Spindle.notes(designed)).chain(within("axis", Axis.notes(designed))).collect()
    }

    fn ranges(&self, designed: &Designed) -> [f64; 2] {
        Spindle.ranges(designed)
    }

    fn start_cycles(&self, designed: &Designed) -> usize {
        Axis.start_cycles(designed)
    }

    fn drill(&self, designed: &Designed) -> Vec<Drill> {
        Spindle.drill(designed)
    }

    /// Its parts say it.
    fn summary(&self, _: &Designed) -> Summary {
        Summary::default()
    }
}
