//! Warnings about a changeover that is legal, but without effect, never reached or misunderstood. No errors here.

use super::limits::rpm;
use super::velocities::asks;
use crate::axis::{Axis, Bus, Changeover, Feedforward, Spindle};
use crate::config::values::key;
use crate::parameters::{Name, Value};
use crate::rules::effective::Effective;
use crate::{
    blocks::position_control::advice::{fits, resolves, slowest},
    codes,
    design::scale,
    diagnostics::Diagnostic,
};

/// Warns of what a user should know before the spindle turns.
pub(crate) fn advise(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    let Some(spindle) = &axis.control.spindle else { return };
    never(axis, spindle, gear, e);
    adds(axis, spindle, e);
    no_effect(spindle, e);
    if let Changeover::Drive { velocity, .. } = &spindle.drive {
        two_weights(e);
        let keys = [key(Name::VelocityCommandData), key(Name::VResoNum)];
        let per_velocity = scale::velocity(velocity, axis.cycle_time_ns);
        fits(axis, e, keys, ("the velocity command at vb_max", axis.ipc.v_max), (per_velocity, velocity.width));
        resolves(axis, e, [Name::VResoNum, Name::VResoDenom].map(key), slowest(axis), per_velocity);
    }
}

/// Warns of a velocity that the spindle does not reach, or that was not given.
fn never(axis: &Axis, spindle: &Spindle, gear: u32, e: &mut Effective<'_>) {
    let on = spindle.v_velocity_control_on;
    let names = [Name::VVelocityControlOn, Name::VelocityPositionControlOn];
    let given = names.into_iter().map(key).find(|key| e.given(*key).is_some());
    let v_max = (Name::VbMax, [gear, 0]);
    let (at, found, instead) = match given {
        None => {
            let title = e.title(key(Name::VVelocityControlOn));
            let speed = rpm(f64::from(on));
            let found = format!(
                "{title} is not given: its default is {on}, and up to {speed} rpm the spindle stays in position control"
            );
            let instead = "v_velocity_control_on with a speed of the spindle: 200 rpm are 1200000".to_owned();
            (key(Name::VPositionControlOn), found, instead)
        }
        // Another message warns of a default that is not the machine's value.
        Some(given) if f64::from(on) >= axis.ipc.v_max && e.given(v_max).is_some() => {
            let [title, largest] = [e.title(given), axis.ipc.v_max.to_string()];
            let found = format!(
                "{title} is {on}, and vb_max {largest} (P-AXIS-00212) is not above it: the spindle stays in position \
                 control"
            );
            let instead =
                format!("v_velocity_control_on below {largest}, or vb_max with the largest speed of the spindle");
            (given, found, instead)
        }
        Some(_) => return,
    };
    e.report.push(Diagnostic::warning(codes::NEVER, e.place_near(at, asks), found).instead(instead));
}

/// Warns of an additive velocity: in velocity control it would be added to the velocity command of the block `spindle`. The
/// block of the whole axis takes it out of that command.
fn adds(axis: &Axis, spindle: &Spindle, e: &mut Effective<'_>) {
    let adds = |of: &&Feedforward| of.additive.velocity && !of.global_disable;
    let Some(feedforward) = axis.control.feedforward.as_ref().filter(adds) else { return };
    let mode = key(Name::FeedforwardMode);
    let other = match spindle.drive {
        Changeover::Cnc => "VEL",
        Changeover::Drive { .. } => "the feedforward of the drive (P-AXIS-00833)",
    };
    let found = format!(
        "{} has ADD_VEL: with the block spindle alone the drive would get the velocity twice in velocity control; spindle_axis sends it \
             once",
        e.title(mode)
    );
    // P-AXIS-00255 overrides G137.
    let first = if feedforward.default_active { "vorsteuer.default_active FALSE, and " } else { "" };
    let instead = format!("spindle_axis; or {first}G137 while `loop_closed` is FALSE; or {other}");
    e.warn(codes::ADDS, mode, found, instead);
}

/// Warns of parameters of another kind of changeover.
fn no_effect(spindle: &Spindle, e: &mut Effective<'_>) {
    use Name::*;
    let sercos = [OpModeForVelocityControl, DriveSettings];
    let canopen = [CyclicPositionOpMode, CyclicVelocityOpMode];
    let weights = [FeedForwardVWeighting, ChangeFeedForwardVWeighting, ProcessDataObjects];
    let (who, idle) = match spindle.drive {
        Changeover::Cnc => ("position control in the CNC", [&sercos[..], &canopen, &weights].concat()),
        Changeover::Drive { bus: Bus::Sercos, .. } => ("a SERCOS drive", canopen.to_vec()),
        Changeover::Drive { bus: Bus::CanOpen, .. } => ("a CANopen drive", sercos.to_vec()),
    };
    let given: Vec<Name> = idle.into_iter().filter(|name| e.given(key(*name)).is_some()).collect();
    let Some(first) = given.first() else { return };
    let listed: Vec<&str> = given.iter().map(|name| name.parameter().id.unwrap_or(name.parameter().path)).collect();
    let found = format!("without effect here: the changeover with {who} does not use {}", listed.join(", "));
    e.warn(codes::NO_EFFECT, key(*first), found, None);
}

/// Warns of P-AXIS-00833 together with a P-AXIS-00766 of another value.
fn two_weights(e: &mut Effective<'_>) {
    let keys = [Name::FeedForwardVWeighting, Name::ChangeFeedForwardVWeighting].map(key);
    let [new, old] = keys.map(|key| e.given(key).and_then(|setting| setting.value.clone()));
    if let (Some(Value::Integer(new)), Some(Value::Integer(old))) = (new, old)
        && new != old
    {
        let found = format!(
            "{} is {old}, and {}, which replaces it, is {new}: {new} holds",
            e.title(keys[1]),
            e.title(keys[0])
        );
        e.warn(codes::TWO_WEIGHTS, keys[1], found, "only P-AXIS-00833".to_owned());
    }
}
