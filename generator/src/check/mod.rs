//! From what was given to an axis that may be designed: defaults, ranges, rules. No file, no syntax, no coefficient.
//!
//! ```text
//! assumed  what nobody gave and something depends on
//! gear     which gear step is used, and what it lacks
//! gantry   slaves find their masters
//! inert    factors of 0, parameters without effect
//! ```
//! The rules of a block are in its folder (`blocks/ipc/check.rs`), what several of them need in `rules`. Only what something uses is
//! validated: vendors' examples carry values in unused parameters that lie outside of their ranges.

pub(crate) mod assumed;
pub(crate) mod gantry;
pub(crate) mod gear;
pub(crate) mod inert;

use crate::axis::{Axis, Control, Ipc};
use crate::blocks::ipc::check as ipc;
use crate::blocks::{FEEDFORWARD, IPC, POSITION_CONTROL};
use crate::blocks::{feedforward::check as feedforward, position_control::check as position_control};
use crate::codes;
use crate::config::values::{Values, key};
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::words::{AxisType, FeedforwardWord, RealType, Words};
use crate::parameters::{Name, Value};
use crate::rules::{drive, effective::Effective};
use portable::RealKind;

/// The cycle time of the set, in ns.
pub(crate) fn cycle_time(values: &Values, missing: Diagnostic, report: &mut Report) -> Option<u32> {
    let key = key(Name::CycleTime);
    if values.get(key).is_none() {
        report.push(missing);
        return None;
    }
    let mut effective = Effective::new(values, Place::whole(""));
    let ns = effective.duration(key).and_then(|ns| u32::try_from(ns).ok());
    report.extend(effective.report);
    ns
}

pub(crate) fn targets(values: &Values) -> Vec<String> {
    match values.get(key(Name::Targets)).and_then(|setting| setting.value.as_ref()) {
        Some(Value::Words(words)) => words.iter().copied().map(str::to_owned).collect(),
        _ => Vec::new(),
    }
}

#[derive(Debug)]
pub(crate) struct Checked<'v> {
    /// it is there if, and only if, no message is an error
    pub(crate) axis: Option<Axis>,
    /// the gear step whose parameters are used
    pub(crate) gear: u32,
    pub(crate) effective: Effective<'v>,
}

/// One axis; its home is where the set names it. Without a cycle time, whose absence has been said, everything that does not
/// need it is validated all the same.
pub(crate) fn axis<'v>(name: &str, cycle_time: Option<u32>, values: &'v Values, home: Place) -> Checked<'v> {
    let mut effective = Effective::new(values, home);
    if let Some(ns) = cycle_time {
        effective.note(key(Name::CycleTime), &Value::Duration(u64::from(ns)));
    }
    let real = effective.word(key(Name::RealType)).map(|real| match real {
        RealType::F64 => RealKind::F64,
        RealType::F32 => RealKind::F32,
    });
    let axis_type = effective.word(key(Name::AxisType));
    gear::check(&mut effective);
    changeover(&mut effective);
    effective.block = Some(IPC);
    let ipc = ipc::check(&mut effective, cycle_time, real);
    let control = control(&mut effective, cycle_time, axis_type, ipc.as_ref());
    let gear = control.as_ref().map_or(0, |(_, gear)| *gear);
    let axis = match (real, cycle_time, ipc, control) {
        (Some(real), Some(cycle_time_ns), Some(ipc), Some((control, _))) if !effective.report.has_errors() => {
            let blocks = [IPC, FEEDFORWARD, POSITION_CONTROL];
            let (canonical, own) = effective.canonical(blocks);
            let canonical_of = blocks.into_iter().zip(own).collect();
            Some(Axis { name: name.to_owned(), real, cycle_time_ns, ipc, control, canonical, canonical_of })
        }
        _ => None,
    };
    Checked { axis, gear, effective }
}

/// A spindle changes to velocity control above the velocity at which it changes back, or there as well.
fn changeover(e: &mut Effective<'_>) {
    let [to_velocity, to_position] = [Name::VVelocityControlOn, Name::VPositionControlOn].map(key);
    let given = |key| match e.given(key).and_then(|setting| setting.value.as_ref()) {
        Some(Value::Integer(velocity)) => Some(*velocity),
        _ => None,
    };
    let (Some(on), Some(off)) = (given(to_velocity), given(to_position)) else { return };
    if on < off {
        let found = format!("{} is {on}, below {} with {off}", e.title(to_velocity), e.title(to_position));
        let said = Diagnostic::error(codes::CHANGEOVER, e.place_of(to_velocity), found);
        let said = said.allowed("v_velocity_control_on >= v_position_control_on [0.001 deg/s]");
        e.report.push(said.instead("both velocities, each at its own name: 200 rpm are 1200000"));
    }
}

/// Feedforward, position control and gantry, with the gear step; none: an error, which has been said.
fn control(
    e: &mut Effective<'_>,
    cycle_time: Option<u32>,
    axis_type: Option<AxisType>,
    ipc: Option<&Ipc>,
) -> Option<(Control, u32)> {
    let number = e.validated_integer(key(Name::AxisNumber))?;
    let is_rotary = match axis_type {
        Some(AxisType::Translator) | None => false,
        Some(AxisType::Rotator | AxisType::Spindle) => true,
    };
    let master = ipc::master(e);
    if ipc.is_some_and(|ipc| !ipc.is_active()) && master.is_none() && !is_asked_for(e) {
        // Nothing of the drive matters: a real machine's list may hold whatever it likes.
        return Some((Control { number, is_rotary, ..Control::default() }, 0));
    }
    // Without a drive, which has been said, the rest is validated all the same.
    let drive = drive::check(e).unwrap_or_default();
    // Of every block the self-test moves within the axis's largest velocity.
    let v_max = (Name::VbMax, [drive.gear, 0]);
    e.block = Some(FEEDFORWARD);
    e.integer(v_max);
    let feedforward = feedforward::check(e, cycle_time, &drive)?;
    e.block = Some(POSITION_CONTROL);
    e.integer(v_max);
    let position_control = position_control::check(e, &drive, ipc, feedforward.as_ref(), master.is_some())?;
    let is_active = ipc.is_some_and(Ipc::is_active) && master.is_none();
    let assumed = e.assumed(|name| assumed::is_told(name, is_active));
    let spindle = None;
    let control =
        Control { feedforward, position_control, spindle, number, is_rotary, master, master_limit: None, assumed };
    Some((control, drive.gear))
}

/// Whether a list asks for more than improved position control.
fn is_asked_for(e: &Effective<'_>) -> bool {
    let none = Value::Words(vec![FeedforwardWord::None.name()]);
    e.all_given().any(|((name, _), setting)| match name {
        Name::FeedforwardMode => setting.value.as_ref() != Some(&none),
        _ => name == Name::Kv,
    })
}
