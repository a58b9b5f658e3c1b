//! From what was given to an axis that may be generated: defaults, ranges, rules. No file, no syntax, no coefficient.
//!
//! ```text
//! effective  given or default, within its range; what the block uses goes into the canonical form
//! ipc        the rules of improved position control: errors
//! drive      where the position is controlled, what the process data hold
//! feedforward, position_control  their rules; corrected: what the controller reports and corrects
//! gantry     slaves find their masters
//! gear       which gear step is used, and what it lacks
//! advice, phase, control_advice, inert, saturation  what is legal, but inert or dangerous: warnings
//! ```
//! Only what a stage's mode uses is judged: vendors' examples carry values in unused parameters that lie outside.

mod advice;
mod control_advice;
mod corrected;
mod drive;
mod effective;
mod feedforward;
pub mod gantry;
mod gear;
mod inert;
mod ipc;
mod phase;
mod position_control;
mod saturation;

use crate::axis::{Axis, Control, Ipc};
use crate::codes;
use crate::config::Values;
use crate::design;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::{Name, Value};
use drive::Drive;
use effective::Effective;
use portable::RealKind;

/// The cycle time of the set, in ns.
pub fn cycle_time(values: &Values<'_>, missing: impl FnOnce() -> Diagnostic) -> (Option<u32>, Report) {
    let key = (Name::CycleTime, [0, 0]);
    if values.get(key).is_none() {
        let mut report = Report::default();
        report.push(missing());
        return (None, report);
    }
    let mut effective = Effective::of(values, Place { file: String::new(), line: 0, column: 0 });
    let ns = effective.duration(key).and_then(|ns| u32::try_from(ns).ok());
    (ns, effective.report)
}

/// The set's targets.
#[must_use]
pub fn targets(values: &Values<'_>) -> Vec<String> {
    match values.get((Name::Targets, [0, 0])).and_then(|setting| setting.value.as_ref()) {
        Some(Value::Words(words)) => words.iter().map(|word| (*word).to_owned()).collect(),
        _ => Vec::new(),
    }
}

/// One axis; its home is where the set names it. The axis is there if, and only if, no message is an error. Without a
/// cycle time, whose absence has been said, everything that does not need it is judged all the same.
#[must_use]
pub fn axis(name: &str, cycle_time: Option<u32>, values: &Values<'_>, home: Place) -> (Option<Axis>, Report) {
    let mut effective = Effective::of(values, home);
    if let Some(ns) = cycle_time {
        effective.note((Name::CycleTime, [0, 0]), &Value::Duration(u64::from(ns)));
    }
    let real = effective.word((Name::RealType, [0, 0])).map(|word| match word {
        "f32" => RealKind::F32,
        _ => RealKind::F64,
    });
    gear::check(&mut effective);
    let ipc = ipc::check(&mut effective, cycle_time, real);
    let control = control(&mut effective, cycle_time, ipc.as_ref());
    let axis = match (real, cycle_time, ipc, control) {
        (Some(real), Some(cycle_time_ns), Some(ipc), Some((control, gear))) if !effective.report.has_errors() => {
            let canonical = effective.canonical();
            Some((Axis { name: name.to_owned(), real, cycle_time_ns, ipc, control, canonical }, gear))
        }
        _ => None,
    };
    let axis = axis.filter(|(axis, gear)| is_usable(axis, &mut effective) && is_finite(axis, *gear, &mut effective));
    if let Some((axis, gear)) = &axis {
        gear::advise(axis, &mut effective);
        advice::advise(axis, &mut effective);
        control_advice::advise(axis, *gear, &mut effective);
    }
    (axis.map(|(axis, _)| axis), effective.report)
}

/// Feedforward, position control and gantry, with the gear step; none: an error, which has been said.
fn control(e: &mut Effective<'_>, cycle_time: Option<u32>, ipc: Option<&Ipc>) -> Option<(Control, u32)> {
    let number = match e.judged((Name::AxisNumber, [0, 0]))? {
        Value::Integer(number) => u32::try_from(number).ok()?,
        _ => return None,
    };
    let turns = e.judged((Name::AxisType, [0, 0])).is_some_and(|kind| kind != Value::Word("ACHSTYP_TRANSLATOR"));
    let master = ipc::master(e);
    if ipc.is_some_and(|ipc| ipc.stage.iter().all(Option::is_none)) && master.is_none() && !is_asked_for(e) {
        // Nothing of the drive matters: a real machine's list may hold whatever it likes.
        return Some((Control { number, turns, ..Control::default() }, 0));
    }
    // Without a drive, which has been said, the rest is judged all the same.
    let drive = drive::check(e).unwrap_or(Drive::UNKNOWN);
    let feedforward = feedforward::check(e, cycle_time, &drive)?;
    let position_control = position_control::check(e, &drive, ipc, feedforward.as_ref(), master.is_some())?;
    let control = Control { feedforward, position_control, number, turns, master, master_limit: None };
    Some((control, drive.gear))
}

/// Whether a list asks for more than improved position control.
fn is_asked_for(e: &Effective<'_>) -> bool {
    let none = Value::Words(vec!["NONE"]);
    e.all_given().any(|((name, _), setting)| match name {
        Name::FeedforwardMode => setting.value.as_ref() != Some(&none),
        _ => name == Name::Kv,
    })
}

/// Whether no scaling leads beyond the numbers of the real type.
fn is_finite(axis: &Axis, gear: u32, e: &mut Effective<'_>) -> bool {
    let Some(found) = design::overflow(axis) else { return true };
    let place = e.place_of((found.parameter, if found.parameter == Name::Load { [gear, 0] } else { [0, 0] }));
    let said =
        format!("{} is {:e}: a usable sample times it is beyond the numbers of this axis", found.what, found.factor);
    e.report.push(Diagnostic::error(codes::SCALE, place, said).instead("the scaling of the drive's manual"));
    false
}

/// Whether all coefficients survive their rounding.
fn is_usable(axis: &Axis, effective: &mut Effective<'_>) -> bool {
    for refusal in design::unusable(axis) {
        let index = indices(&refusal.path);
        let of_damping = refusal.path.ends_with("oscillation");
        let name = if of_damping { ipc::damping_given(effective, index[0]) } else { Name::FilterF0 };
        let place = effective.place_of((name, index));
        let found = format!("{}: {}", refusal.path, refusal.found);
        let diagnostic = Diagnostic::error(codes::ROUNDING, place, found);
        effective.report.push(diagnostic.allowed(refusal.allowed).instead(refusal.instead));
    }
    !effective.report.has_errors()
}

/// The indices of stage and filter in a path of coefficients, such as `stage[0].filter[1].bandpass[2]`.
fn indices(path: &str) -> [u32; 2] {
    let of = |part: &str| {
        let digits = path.split_once(part)?.1.split(']').next()?;
        digits.parse().ok()
    };
    [of("stage[").unwrap_or(0), of("filter[").unwrap_or(0)]
}
