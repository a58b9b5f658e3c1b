//! The block `spindle`: the change between position and velocity control.

pub(crate) mod advice;
pub(crate) mod check;
pub(crate) mod design;
mod diff;
mod drill;
mod in_drive;
mod lag;
mod limits;
pub(crate) mod notes;
mod offered;
mod op_modes;
mod velocities;
mod window;
pub(crate) mod words;

use super::{BlockKind, Design, Drill, Summary, effects::Effects};
use crate::{axis::Axis, blocks::designed::Designed};
use reference::spindle::{Coeffs, Spindle};

impl Design for Spindle {
    type Single = f32;

    fn design(designed: &Designed) -> Coeffs<f64> {
        designed.spindle
    }
}

impl BlockKind for Spindle {
    fn is_asked_for(&self, axis: &Axis) -> bool {
        axis.control.spindle.is_some()
    }

    fn short_name(&self) -> &'static str {
        "sp"
    }

    fn purpose(&self, designed: &Designed) -> String {
        format!("Changeover of a spindle between position and velocity control. {}", changeover(&designed.spindle))
    }

    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        notes::notes(&designed.axis)
    }

    /// The quiet noise stays within the window of the takeover, so that the spindle stays in position control.
    fn ranges(&self, designed: &Designed) -> [f64; 2] {
        let coeffs = &designed.spindle;
        [(coeffs.takeover_window / 4.0).clamp(1e-3, 400.0), coeffs.v_velocity_control_on.clamp(6000.0, 2e9)]
    }

    fn drill(&self, designed: &Designed) -> Vec<Drill> {
        drill::through_all_states(&designed.spindle)
    }

    fn summary(&self, designed: &Designed) -> Summary {
        Summary { lines: words::lines(&designed.axis), ..Summary::default() }
    }

    fn effects(&self, designed: &Designed) -> Effects {
        diff::effects(&designed.axis)
    }
}

/// Who changes over, what the first calls do, and what happens while there is none.
pub(super) fn changeover(coeffs: &Coeffs<f64>) -> String {
    let how = match coeffs {
        Coeffs { only_velocity: true, .. } => "The drive has velocity control alone.",
        Coeffs { in_drive: true, .. } => "The drive changes its operation mode.",
        Coeffs { .. } => "The CNC opens and closes its position loop; the drive stays in velocity control.",
    };
    format!(
        "{how} It begins in TO_POSITION, where its commands follow the spindle; with the drive on it takes hold of the spindle after \
         three consecutive valid samples of v_actual. A request that is TRUE in the first call does not count. While the block is not \
         called, the commands keep their last values: under velocity control the spindle goes on turning."
    )
}
