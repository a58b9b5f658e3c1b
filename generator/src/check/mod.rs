//! From given values to an axis that may be designed: defaults, ranges, rules. No file, no syntax, no coefficient.
//!
//! ```text
//! askew          what skews a gantry while it moves
//! assumed        values that were not given although something depends on them
//! cnc_functions  functions of the CNC that no block has
//! gear           the gear step in use, and its missing parameters
//! gantry         slaves and their masters
//! inert          factors of 0, parameters without effect
//! units          numbers that are probably in another unit
//! ```
//! The rules of a block are in its folder (`blocks/ipc/check.rs`); rules that several blocks need are in `rules`. Only
//! values in use are validated: vendors' examples contain unused parameters that are out of range.

mod askew;
pub(crate) mod assumed;
pub(crate) mod cnc_functions;
pub(crate) mod gantry;
pub(crate) mod gear;
pub(crate) mod inert;
pub(crate) mod units;

use self::assumed::Depends;
use crate::axis::{Axis, Control, DriveModel, Ipc};
use crate::blocks::ipc::{check as ipc, drive_model};
use crate::blocks::spindle::check as spindle;
use crate::blocks::{EXCITATION, FEEDFORWARD, IPC, POSITION_CONTROL, SPINDLE};
use crate::blocks::{
    excitation::check as excitation, feedforward::check as feedforward, position_control::check as position_control,
};
use crate::codes;
use crate::config::values::{Key, Values, key};
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::words::{AxisType, Boolean, DriveType, FeedforwardWord, RealType, Words};
use crate::parameters::{Name, Value};
use crate::rules::{drive, effective::Effective, presence::Presence};
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
    /// `Some` if and only if no message is an error
    pub(crate) axis: Option<Axis>,
    /// the gear step whose parameters are used
    pub(crate) gear: u32,
    pub(crate) effective: Effective<'v>,
}

/// One axis; its home is where the set names it. If the cycle time is missing, which has been reported, everything that does
/// not need it is still validated. The drive matters if a stage is active, or is to be proposed.
pub(crate) fn axis<'v>(
    name: &str,
    cycle_time: Option<u32>,
    values: &'v Values,
    home: Place,
    is_tuned: bool,
) -> Checked<'v> {
    checked(name, cycle_time, Effective::new(values, home), is_tuned)
}

/// The same with another value of a parameter, whether it is given or not.
pub(crate) fn varied<'v>(
    (name, values, home): (&str, &'v Values, Place),
    cycle_time: u32,
    other: (Key, Value),
) -> Checked<'v> {
    checked(name, Some(cycle_time), Effective::varied(values, home, other), false)
}

fn checked<'v>(name: &str, cycle_time: Option<u32>, mut effective: Effective<'v>, is_tuned: bool) -> Checked<'v> {
    if let Some(ns) = cycle_time {
        effective.note(key(Name::CycleTime), &Value::Duration(u64::from(ns)));
    }
    let (axis, gear) = validated(name, cycle_time, &mut effective, is_tuned).unzip();
    Checked { axis, gear: gear.unwrap_or_default(), effective }
}

/// The axis with its gear step; `None` after a reported error.
fn validated(name: &str, cycle_time: Option<u32>, e: &mut Effective<'_>, is_tuned: bool) -> Option<(Axis, u32)> {
    let real = e.word(key(Name::RealType)).map(|real| match real {
        RealType::F64 => RealKind::F64,
        RealType::F32 => RealKind::F32,
    });
    let short_names = short_names(e, name);
    let counts_calls = counts_calls(e);
    let changes_over = spindle::is_asked_for(e);
    let axis_type = e.word(key(Name::AxisType));
    gear::check(e);
    e.block = Some(IPC);
    let ipc = ipc::check(e, cycle_time, real);
    let control = control(e, cycle_time, (axis_type, changes_over), ipc.as_ref());
    e.block = Some(EXCITATION);
    let excitation = excitation::check(e, cycle_time);
    let has_stages = is_tuned || ipc.as_ref().is_none_or(Ipc::is_active);
    let drive = drive_of_stages(e, has_stages, control.as_ref().map(|(control, _)| control));
    if e.report.has_errors() {
        return None;
    }
    let blocks = [IPC, FEEDFORWARD, POSITION_CONTROL, SPINDLE, EXCITATION];
    let (canonical, own) = e.canonical(blocks);
    let (control, gear) = control?;
    let axis = Axis {
        name: name.to_owned(),
        real: real?,
        short_names: short_names?,
        cycle_time_ns: cycle_time?,
        counts_calls: counts_calls?,
        ipc: ipc?,
        control,
        excitation: excitation?.present(),
        drive: drive?,
        canonical,
        canonical_of: blocks.into_iter().zip(own).collect(),
    };
    Some((axis, gear))
}

/// The drive, if stages act or are to be proposed; else the default one.
fn drive_of_stages(e: &mut Effective<'_>, has_stages: bool, control: Option<&Control>) -> Option<DriveModel> {
    if has_stages || control.is_some_and(|control| control.position_control.is_some()) {
        drive::shorter_delay(e);
    }
    if has_stages { drive_model::check(e) } else { Some(DriveModel::default()) }
}

/// The length of an axis name for which `ax_NAME_ipc_inputs_init` has 31 characters.
const LONGEST_OF_SHORT_NAMES: usize = 12;

/// Whether names have to be short in C. This changes only names, so the digest of the parameters does not cover it.
fn short_names(e: &mut Effective<'_>, name: &str) -> Option<bool> {
    let asked = key(Name::ShortNames);
    let is_wanted = e.validated_word::<Boolean>(asked)? == Boolean::True;
    if is_wanted && name.len() > LONGEST_OF_SHORT_NAMES {
        let found = format!("{} of the axis `{name}`, whose name has {} characters", e.title(asked), name.len());
        let allowed = format!("short_names of an axis with a name of at most {LONGEST_OF_SHORT_NAMES} characters");
        e.refuse(codes::AXIS_NAME, asked, found, [Some(allowed), Some("a shorter name for the axis".to_owned())]);
    }
    Some(is_wanted)
}

/// Whether the blocks check the call rate. The digest of the parameters covers the key only if they do.
fn counts_calls(e: &mut Effective<'_>) -> Option<bool> {
    let is_counted = e.validated_word::<Boolean>(key(Name::CycleCounter))? == Boolean::True;
    if is_counted {
        e.word::<Boolean>(key(Name::CycleCounter))?;
    }
    Some(is_counted)
}

/// Feedforward, position control, changeover and gantry, with the gear step; `None` after a reported error.
fn control(
    e: &mut Effective<'_>,
    cycle_time: Option<u32>,
    (axis_type, changes_over): (Option<AxisType>, bool),
    ipc: Option<&Ipc>,
) -> Option<(Control, u32)> {
    let number = e.validated_integer(key(Name::AxisNumber))?;
    let is_spindle = axis_type == Some(AxisType::Spindle);
    let is_rotary = is_spindle || axis_type == Some(AxisType::Rotator);
    let master = ipc::master(e);
    let control = Control { number, is_rotary, is_spindle, master, drive_type: drive_type(e), ..Control::default() };
    if ipc.is_some_and(|ipc| !ipc.is_active()) && master.is_none() && !changes_over && !is_asked_for(e) {
        // The drive does not matter: a real machine's list may contain any values for it.
        return Some((control, 0));
    }
    control_with_drive(e, cycle_time, (axis_type, changes_over), ipc, control)
}

/// The same for an axis whose drive matters.
fn control_with_drive(
    e: &mut Effective<'_>,
    cycle_time: Option<u32>,
    (axis_type, changes_over): (Option<AxisType>, bool),
    ipc: Option<&Ipc>,
    control: Control,
) -> Option<(Control, u32)> {
    // Without a drive, which has been reported, the rest is still validated.
    let drive = drive::check(e).unwrap_or_default();
    let [is_slave, has_stages] = [control.master.is_some(), ipc.is_some_and(Ipc::is_active)];
    // The self-test of every block moves within the axis's largest velocity.
    let v_max = (Name::VbMax, [drive.gear, 0]);
    e.block = Some(FEEDFORWARD);
    e.integer(v_max);
    let feedforward = feedforward::check(e, cycle_time, &drive);
    let has_feedforward = feedforward.as_ref().and_then(Presence::as_present);
    e.block = Some(POSITION_CONTROL);
    e.integer(v_max);
    let position_control = position_control::check(e, (&drive, cycle_time), ipc, has_feedforward, is_slave);
    e.block = Some(SPINDLE);
    let spindle = if changes_over {
        spindle::check(e, cycle_time, &drive, has_feedforward, [is_slave, has_stages]).map(Presence::Present)
    } else {
        spindle::no_changeover(e, cycle_time, axis_type, &drive);
        Some(Presence::Absent)
    };
    let (feedforward, position_control) = (feedforward?.present(), position_control?.present());
    let spindle = spindle?.present();
    let is_limited = has_stages && !is_slave || spindle.is_some();
    let depends = Depends::new(is_limited, feedforward.as_ref(), position_control.as_ref());
    let assumed = e.assumed(|name| depends.is_told(name));
    let location = drive.is_stated.then_some(drive.location);
    let kv = kv(e, drive.gear);
    Some((Control { feedforward, position_control, spindle, assumed, location, kv, ..control }, drive.gear))
}

/// The drive type, if given, even if no block depends on it.
fn drive_type(e: &Effective<'_>) -> Option<DriveType> {
    match e.given(key(Name::DriveType))?.value {
        Some(Value::Word(word)) => DriveType::named(word),
        _ => None,
    }
}

/// Kv, if it is given or if a block uses its default.
fn kv(e: &mut Effective<'_>, gear: u32) -> Option<u32> {
    let kv = (Name::Kv, [gear, 0]);
    let is_readable = e.given(kv).is_some_and(|setting| setting.value.is_some());
    if is_readable || e.is_used(kv) { e.validated_integer(kv) } else { None }
}

/// Whether a list asks for more than improved position control.
fn is_asked_for(e: &Effective<'_>) -> bool {
    let none = Value::Words(vec![FeedforwardWord::None.name()]);
    let feeds_forward = |value: &Option<Value>| value.as_ref() != Some(&none);
    e.all_given()
        .any(|((name, _), setting)| name == Name::Kv || name == Name::FeedforwardMode && feeds_forward(&setting.value))
}
