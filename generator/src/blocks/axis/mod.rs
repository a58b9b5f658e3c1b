//! The block `axis`: feedforward, position control and improved position control in this order; and gantry slaves.

use super::effects::{Effect, Effects, of_part};
use super::ipc::notes::{self as ipc_notes, cycle_time, note};
use super::ipc::{sets, with_sets};
use super::{BlockKind, Design, Figure, Summary, Typed, feedforward, ipc, position_control, spindle};
use crate::axis::Location;
use crate::{blocks::designed::Designed, number::digits};
use portable::Extreme;
use reference::axis::{Addition, Axis, Coeffs};
use reference::call_rate;
use reference::feedforward::Feedforward;
use reference::ipc::Ipc;
use reference::tunable_axis::{self, TunableAxis};

impl Design for Axis {
    type Single = f32;

    fn design(designed: &Designed) -> Coeffs<f64> {
        let axis = &designed.axis;
        let limit = axis.control.master_limit.unwrap_or(0.0);
        // The axis counts the calls for its parts.
        let uncounted = call_rate::Coeffs::default();
        let in_drive = axis.control.position_control.as_ref().is_some_and(|of| of.location != Location::Cnc);
        Coeffs {
            cycle_time_ns: axis.cycle_time_ns,
            addition: position_control::design::addition(axis),
            has_feedforward: axis.control.feedforward.is_some(),
            counts_turns: axis.control.is_spindle && in_drive,
            v_largest: spindle::design::v_largest(axis),
            largest_v_add: designed.ipc.limit,
            master_limit: limit,
            master_lower_limit: 0.0 - limit, // not `-limit`: 0 stays +0
            feedforward: reference::feedforward::Coeffs { call_rate: uncounted, ..designed.feedforward },
            ipc: reference::ipc::Coeffs { call_rate: uncounted, ..designed.ipc },
            position_control: reference::position_control::Coeffs { call_rate: uncounted, ..designed.position_control },
            call_rate: call_rate::Coeffs { active: axis.counts_calls },
        }
    }

    fn other(designed: &Designed) -> Option<&'static dyn Typed> {
        designed.axis.ipc.takes_sets().then_some(&TunableAxis)
    }
}

impl Design for TunableAxis {
    type Single = f32;

    fn design(designed: &Designed) -> tunable_axis::Coeffs<f64> {
        tunable_axis::Coeffs { sets: sets::coefficients(designed), axis: Axis::design(designed) }
    }
}

impl BlockKind for Axis {
    fn is_asked_for(&self, axis: &crate::axis::Axis) -> bool {
        axis.control.position_control.is_some() && axis.control.spindle.is_none()
    }

    fn short_name(&self) -> &'static str {
        "ax"
    }

    fn purpose(&self, designed: &Designed) -> String {
        format!(
            "The whole axis: {}. {}",
            parts(designed).join(", "),
            position_control::from_the_first_call(designed.position_control.location)
        )
    }

    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        with_sets::notes(designed, notes(designed), ["sets.", "axis."])
    }

    fn ranges(&self, designed: &Designed) -> [f64; 2] {
        let [quiet, loud] = Ipc.ranges(designed);
        let [other_quiet, other_loud] = Feedforward.ranges(designed);
        [quiet.smaller(other_quiet), loud.larger(other_loud)]
    }

    fn start_cycles(&self, designed: &Designed) -> usize {
        Ipc.start_cycles(designed)
    }

    fn summary(&self, designed: &Designed) -> Summary {
        let control = &designed.axis.control;
        let limit = control.master_limit.map(|limit| format!(": puts out its v_add, |v_add| <= {}", digits(limit)));
        let line = control.master.map(|master| format!("gantry slave of axis {master}{}", limit.unwrap_or_default()));
        Summary { lines: line.into_iter().collect(), ..Summary::default() }
    }

    fn effects(&self, designed: &Designed) -> Effects {
        let limit = designed.axis.control.master_limit;
        of_part("gantry", [("limit of the master", limit.map(|limit| Effect::Number(limit, "")))])
    }

    fn limit(&self, designed: &Designed) -> Option<Figure> {
        ipc::limit(designed)
    }
}

/// The parts of the block that the axis has, in their order.
pub(super) fn parts(designed: &Designed) -> Vec<&'static str> {
    let of: Coeffs<f64> = Axis::design(designed);
    let only_velocity = designed.spindle.only_velocity;
    let parts = [
        (of.has_feedforward, "feedforward"),
        (!only_velocity && of.position_control.location == Location::Cnc, "position control in the CNC"),
        (of.position_control.location != Location::Cnc, "commands for the drive, which controls the position"),
        (of.addition == Addition::Ipc, "improved position control, whose v_add fades in"),
        (of.addition == Addition::Sets, "improved position control with parameter sets, whose v_add fades in"),
        (of.addition == Addition::Master, "the v_add of the gantry's master"),
    ];
    parts.into_iter().filter(|(exists, _)| *exists).map(|(_, part)| part).collect()
}

/// The notes of the block with constants and of its parts.
pub(super) fn notes(designed: &Designed) -> Vec<(String, String)> {
    let axis = &designed.axis;
    let within = |part: &'static str, notes: Vec<(String, String)>| {
        notes.into_iter().map(move |(path, text)| (format!("{part}.{path}"), text))
    };
    let mut notes = vec![note("cycle_time_ns", cycle_time(axis))];
    if axis.control.is_spindle {
        let end = digits(spindle::design::half_turn(axis) / spindle::notes::RPM);
        notes.push(note("v_largest", format!("below {end} rpm")));
    }
    if let Some(limit) = axis.control.master_limit {
        let limit = digits(limit);
        let text = format!("largest |v_add| = {limit} of the gantry's master (P-AXIS-00070, 00757, 00212)");
        notes.push(note("master_limit", text));
    }
    notes.extend(within("feedforward", feedforward::notes::notes(axis)));
    notes.extend(within("ipc", ipc_notes::notes(designed)));
    notes.extend(within("position_control", position_control::notes::notes(axis)));
    notes
}
