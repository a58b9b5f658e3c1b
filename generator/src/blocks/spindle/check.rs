//! The rules of a spindle that changes between position and velocity control, and the condition for an axis to be one.

use super::velocities::{self, VELOCITIES, Velocities};
use super::{in_drive, lag, limits, window};
use crate::axis::{Changeover, Feedforward, Location, Spindle};
use crate::config::values::key;
use crate::parameters::words::{AxisType, DriveType, Words};
use crate::parameters::{Name, Value};
use crate::rules::drive::{self, Drive};
use crate::rules::effective::{Effective, as_written};
use crate::{codes, diagnostics::Diagnostic};

/// axgen's own keys that only a changeover uses.
pub(crate) const KEYS: [Name; 7] = [
    Name::ProcessDataObjects,
    Name::DriveSettings,
    Name::SpindleDeceleration,
    Name::SpindleWindow,
    Name::SpindleTakeoverWindow,
    Name::SpindleModeTimeout,
    Name::SpindleBrakeTimeout,
];

/// Whether the axis changes over: a spindle (P-AXIS-00018) with a velocity of the changeover. Examples in the manual have no
/// axis type: such an axis is taken for a spindle.
pub(crate) fn is_asked_for(e: &mut Effective<'_>) -> bool {
    // No other function has these keys: a wrong value is an error on any axis.
    for own in KEYS.map(key) {
        if e.given(own).is_some() {
            e.validated(own);
        }
    }
    let given: Vec<Name> = VELOCITIES.into_iter().filter(|name| e.given(key(*name)).is_some()).collect();
    let Some(first) = given.first().map(|name| key(*name)) else { return false };
    let ids = given.iter().filter_map(|name| name.parameter().id).collect::<Vec<_>>().join(", ");
    let spindle = AxisType::Spindle.name();
    let type_key = key(Name::AxisType);
    match e.given(type_key).map(|setting| setting.value.as_ref()) {
        None => {
            e.adopt(type_key, Value::Word(spindle));
            let found =
                format!("{} is not given: the axis is taken for a spindle, because of {ids}", e.title(type_key));
            let instead = as_written(&e.place_of(first), type_key, &[spindle]);
            e.warn(codes::TAKEN_FOR_SPINDLE, first, found, instead);
            true
        }
        Some(Some(Value::Word(word))) if *word == spindle => true,
        // An unreadable type is reported where it is used.
        Some(None) => false,
        Some(Some(other)) => {
            let found = format!("the axis is {} (P-AXIS-00018), no spindle: {ids} without effect", other.text());
            let instead = as_written(&e.place_of(type_key), type_key, &[spindle]) + ", if it is a spindle";
            e.warn(codes::NO_EFFECT, first, found, instead);
            false
        }
    }
}

/// The changeover of a spindle; `None` after a reported error.
pub(crate) fn check(
    e: &mut Effective<'_>,
    cycle_time: Option<u32>,
    drive: &Drive,
    feedforward: Option<&Feedforward>,
    [is_slave, has_stages]: [bool; 2],
) -> Option<Spindle> {
    drive::note(e, &[Name::DriveType, Name::OperationMode]);
    let velocities = velocities::check(e, drive.gear);
    let are_zero = velocities.is_some_and(|of| of.on.value == 0 && of.off.value == 0);
    let is_alone = drive.location != Location::Cnc && are_zero;
    refuse(e, is_slave, is_alone && has_stages);
    let kv_key = (Name::Kv, [drive.gear, 0]);
    let kv = if is_alone { Some(0) } else { e.integer(kv_key) };
    let deceleration = e.real(key(Name::SpindleDeceleration));
    let changing = velocities.as_ref().filter(|_| !is_alone);
    let window = window::settled(e, cycle_time, drive.gear, changing);
    let takeover_window = e.real(key(Name::SpindleTakeoverWindow));
    let (changeover, delay_cycles) = changeover(e, drive.location, feedforward, is_alone);
    let counted = counted(e, feedforward.filter(|_| !is_alone));
    if let (Some(changeover), Some(of), Some(kv), Some(window)) = (&changeover, changing, kv, window) {
        lags(e, (changeover, cycle_time), counted, of, window, lag::Gain { key: kv_key, kv });
    }
    let [mode_timeout_ns, brake_timeout_ns] =
        limits::check(e, (drive.location, cycle_time), (velocities, is_alone), [window, deceleration], delay_cycles);
    Some(Spindle {
        v_velocity_control_on: velocities?.on.value,
        v_position_control_on: velocities?.off.value,
        drive: changeover?,
        feedforward: counted.map(|of| of.weight),
        default_active: counted.is_some_and(|of| of.default_active),
        kv: kv?,
        delay_cycles: delay_cycles?,
        deceleration: deceleration?,
        window: window?,
        takeover_window: takeover_window?,
        mode_timeout_ns: mode_timeout_ns?,
        brake_timeout_ns: brake_timeout_ns?,
    })
}

/// Refuses the changeover of a gantry slave, and active stages of a drive with velocity control alone, which never act.
fn refuse(e: &mut Effective<'_>, is_slave: bool, has_useless_stages: bool) {
    if is_slave {
        let found =
            "a gantry slave (P-AXIS-00070) follows its master's position, and cannot change to velocity control";
        let said = Diagnostic::error(codes::GANTRY_SPINDLE, e.place_of(key(Name::GantryMaster)), found);
        e.report.push(said.instead("no gantry, or no P-AXIS-00767 and P-AXIS-00768"));
    }
    if has_useless_stages {
        let found = "improved position control has stages, and the drive has velocity control alone: Von and Voff are \
                     0 (P-AXIS-00767, 00768)";
        let said = Diagnostic::error(codes::ONLY_VELOCITY, e.place_of(key(Name::VVelocityControlOn)), found);
        e.report
            .push(said.instead("Von and Voff of a drive with position control, or the mode NOT_ACTIVE of each stage"));
    }
}

/// The changeover, and the cycles between a command and its actual value; each is `None` after a reported error.
fn changeover(
    e: &mut Effective<'_>,
    location: Location,
    feedforward: Option<&Feedforward>,
    is_alone: bool,
) -> (Option<Changeover>, Option<u32>) {
    if location == Location::Cnc {
        return (Some(Changeover::Cnc), Some(0));
    }
    (in_drive::check(e, location, feedforward, is_alone), in_drive::delay_cycles(e, is_alone))
}

/// The position lag, of the loop in the CNC or where the drive takes up position control.
fn lags(
    e: &mut Effective<'_>,
    (changeover, cycle_time): (&Changeover, Option<u32>),
    feedforward: Option<&Feedforward>,
    of: &Velocities,
    least_window: f64,
    gain: lag::Gain,
) {
    match changeover {
        Changeover::Cnc => {
            let weight = feedforward.map_or(0.0, |of| of.weight.value());
            lag::in_cnc(e, of, gain, (weight, feedforward.is_none_or(|of| of.default_active)));
            if let Some(ns) = cycle_time {
                lag::seen(e, of, ns);
            }
        }
        Changeover::Drive { feed_forward_v_weighting, .. } => {
            let part = (1.0 - f64::from(*feed_forward_v_weighting) / 1000.0).abs();
            lag::in_drive(e, of, least_window, gain, part);
        }
    }
}

/// An axis without a changeover: the rules of every spindle whose drive controls the position, and operation modes that it
/// does not have.
pub(crate) fn no_changeover(
    e: &mut Effective<'_>,
    cycle_time: Option<u32>,
    axis_type: Option<AxisType>,
    drive: &Drive,
) {
    let is_spindle = axis_type == Some(AxisType::Spindle);
    if let (true, true, Some(ns)) = (is_spindle, drive.location != Location::Cnc, cycle_time) {
        limits::half_a_revolution_at_most(e, ns, (Name::VbMax, [drive.gear, 0]));
    }
    let Some(drive_type) = e.validated_word::<DriveType>(key(Name::DriveType)) else { return };
    let mut idle = Vec::new();
    if drive_type != DriveType::CanOpen {
        idle.extend([Name::CyclicPositionOpMode, Name::CyclicVelocityOpMode]);
    }
    if drive_type != DriveType::Sercos || !is_spindle {
        idle.push(Name::OpModeForVelocityControl);
    }
    let given: Vec<Name> = idle.into_iter().filter(|name| e.given(key(*name)).is_some()).collect();
    let Some(first) = given.first() else { return };
    let listed: Vec<&str> = given.iter().filter_map(|name| name.parameter().id).collect();
    let kind = axis_type.map_or("of no type", Words::name);
    let found = format!(
        "without effect here: an axis that is {kind} (P-AXIS-00018) with a drive that is {} (P-AXIS-00020) does not have {}",
        drive_type.name(),
        listed.join(", ")
    );
    e.warn(codes::NO_EFFECT, key(*first), found, None);
}

/// The feedforward of the velocity that reduces the position lag: any one of the CNC, of a drive that controls the position an
/// additive one.
fn counted<'f>(e: &mut Effective<'_>, feedforward: Option<&'f Feedforward>) -> Option<&'f Feedforward> {
    let of = feedforward.filter(|of| of.sums().velocity && !of.global_disable)?;
    let names = [Name::FeedforwardMode, Name::VsVFaktor, Name::VsVNenner, Name::DefaultActive, Name::GlobalDisable];
    drive::note(e, &names);
    Some(of)
}
