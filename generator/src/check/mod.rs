//! From what was given to an axis that may be generated: defaults, ranges, rules. No file, no syntax, no coefficient.
//!
//! ```text
//! effective  given or default, within its range; what the block uses goes into the canonical form
//! ipc        the rules of improved position control: errors
//! advice     what is legal, but inert or dangerous: warnings
//! ```
//! Only what a stage's mode uses is judged: vendors' examples carry values in unused parameters that lie outside.

mod advice;
mod effective;
mod ipc;

use crate::axis::Axis;
use crate::codes;
use crate::config::Values;
use crate::design;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::{Name, Value};
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
    let ipc = ipc::check(&mut effective, cycle_time, real);
    let axis = match (real, cycle_time, ipc) {
        (Some(real), Some(cycle_time_ns), Some(ipc)) if !effective.report.has_errors() => {
            let canonical = effective.canonical();
            Some(Axis { name: name.to_owned(), real, cycle_time_ns, ipc, canonical })
        }
        _ => None,
    };
    let axis = axis.filter(|axis| is_usable(axis, &mut effective));
    if let Some(axis) = &axis {
        advice::advise(axis, &mut effective);
    }
    (axis, effective.report)
}

/// Whether all coefficients survive their rounding.
fn is_usable(axis: &Axis, effective: &mut Effective<'_>) -> bool {
    for refusal in design::unusable(axis) {
        let index = indices(&refusal.path);
        let place = effective.place_of((Name::FilterF0, index));
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
