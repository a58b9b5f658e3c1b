//! The block `spindle_axis`: the changeover with feedforward, position control and improved position control.

use super::ipc::{sets, with_sets};
use super::{BlockKind, Design, Drill, Figure, Summary, Typed, axis, ipc, spindle};
use crate::blocks::designed::Designed;
use portable::Literal;
use reference::axis::Axis;
use reference::ipc::mode_off;
use reference::spindle::Spindle;
use reference::spindle_axis::{Coeffs, SpindleAxis};
use reference::tunable_spindle_axis::{self, TunableSpindleAxis};

impl Design for SpindleAxis {
    type Single = f32;

    fn design(designed: &Designed) -> Coeffs<f64> {
        // A loop in a drive or in another block has its own encoder.
        let spindle = reference::spindle::Coeffs { closes_loop: !designed.spindle.in_drive, ..designed.spindle };
        Coeffs { spindle, axis: Axis::design(designed) }
    }

    fn other(designed: &Designed) -> Option<&'static dyn Typed> {
        designed.axis.ipc.takes_sets().then_some(&TunableSpindleAxis)
    }
}

impl Design for TunableSpindleAxis {
    type Single = f32;

    fn design(designed: &Designed) -> tunable_spindle_axis::Coeffs<f64> {
        let spindle_axis = SpindleAxis::design(designed);
        tunable_spindle_axis::Coeffs { sets: sets::coefficients(designed), spindle_axis }
    }
}

impl BlockKind for SpindleAxis {
    fn is_asked_for(&self, axis: &crate::axis::Axis) -> bool {
        axis.control.spindle.is_some()
    }

    fn short_name(&self) -> &'static str {
        "sx"
    }

    fn purpose(&self, designed: &Designed) -> String {
        let (parts, changeover) = (axis::parts(designed), spindle::changeover(&designed.spindle));
        let parts = [vec!["changeover between position and velocity control"], parts].concat().join(", ");
        format!("The whole axis of a spindle: {parts}. {changeover}")
    }

    /// The notes of its parts.
    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        let within = |part: &'static str, notes: Vec<(String, String)>| {
            notes.into_iter().map(move |(path, text)| (format!("{part}.{path}"), text))
        };
        let of_axis = axis::notes(designed);
        let notes = within("spindle", Spindle.notes(designed)).chain(within("axis", of_axis)).collect();
        with_sets::notes(designed, notes, ["sets.", "spindle_axis."])
    }

    fn ranges(&self, designed: &Designed) -> [f64; 2] {
        Spindle.ranges(designed)
    }

    fn start_cycles(&self, designed: &Designed) -> usize {
        Axis.start_cycles(designed)
    }

    /// Improved position control is turned off for two samples in POSITION, before the changeover begins.
    fn drill(&self, designed: &Designed) -> Vec<Drill> {
        let mut parts = Spindle.drill(designed);
        parts.push(Drill { input: "mode", value: Literal::I32(mode_off()), samples: 3..5 });
        parts
    }

    /// The summaries of its parts cover it.
    fn summary(&self, _: &Designed) -> Summary {
        Summary::default()
    }

    fn limit(&self, designed: &Designed) -> Option<Figure> {
        ipc::limit(designed)
    }
}
