//! The changeover of an axis as named values, each in its unit, for the semantic diff.

use super::super::effects::{Effect, Effects, of_part};
use super::design::{kv, weight};
use super::limits::window;
use super::notes::RPM;
use crate::axis::{Axis, Changeover, Velocity};
use crate::{design::scale, parameters::words::Words};

/// The values of the changeover; empty without it.
pub(crate) fn effects(axis: &Axis) -> Effects {
    let Some(of) = &axis.control.spindle else { return Effects::new() };
    let rpm = |velocity: f64| Some(Effect::Number(velocity / RPM, " rpm"));
    let [on, off] = [of.v_velocity_control_on, of.v_position_control_on].map(f64::from);
    let seconds = |ns: u64| Some(Effect::Number(ns as f64 / 1e9, " s"));
    let (place, modes, velocity) = match &of.drive {
        Changeover::Cnc => ("in the CNC", None, None),
        Changeover::Drive { position_mode, velocity_mode, velocity, .. } => {
            ("in the drive", Some(format!("{position_mode} and {velocity_mode}")), Some(velocity))
        }
    };
    let scaling = |velocity: &Velocity| scale::velocity(velocity, axis.cycle_time_ns) * RPM;
    let width = |velocity: &Velocity| Effect::Words(velocity.width.name().to_owned());
    let values = [
        ("place", Some(Effect::Words(place.to_owned()))),
        ("operation modes", modes.map(Effect::Words)),
        ("velocity command", velocity.map(|velocity| Effect::Number(scaling(velocity), " increments at 1 rpm"))),
        ("process data of the velocity command", velocity.map(width)),
        ("velocity control from", rpm(on)),
        ("position control from", rpm(off)),
        ("window", rpm(window(of.v_position_control_on, of.window))),
        ("deceleration", Some(Effect::Number(of.deceleration / RPM, " rpm/s"))),
        ("Kv", (!of.only_velocity()).then(|| Effect::Number(kv(of), "/s"))),
        ("weight of the drive's feedforward", Some(Effect::Number(weight(of), ""))),
        ("delay", Some(Effect::Number(f64::from(of.delay_cycles), " cycles"))),
        ("take-over window", Some(Effect::Number(of.takeover_window / 1000.0, " deg"))),
        ("time of a change of mode", seconds(of.mode_timeout_ns)),
        ("time to brake", seconds(of.brake_timeout_ns)),
    ];
    of_part("spindle", values)
}
