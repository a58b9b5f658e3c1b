//! Position control of an axis as named values, each in its unit, for the semantic diff.

use super::super::effects::{Effect, Effects, of_part};
use super::design::kv;
use crate::axis::{Axis, Location, Resolution, Velocity, Width};
use crate::{design::scale, parameters::words::Words};

/// The values of position control; empty without it.
pub(crate) fn effects(axis: &Axis) -> Effects {
    let Some(of) = &axis.control.position_control else { return Effects::new() };
    let in_cnc = of.location == Location::Cnc;
    let scaling = |scale: f64| Effect::Number(scale * 1e6 / 60.0, " increments at 1 m/min or 1000 deg/min");
    let additive = |velocity: Velocity| scaling(scale::velocity(&velocity, axis.cycle_time_ns));
    let width = |width: Width| Effect::Words(width.name().to_owned());
    let resolution = |of: &Resolution| Effect::Number(scale::resolution(of) * 1e4, " increments per mm or deg");
    let values = [
        ("place", Some(Effect::Words(place(of.location).to_owned()))),
        ("Kv", (of.kv > 0).then(|| Effect::Number(kv(of), "/s"))),
        ("velocity command", in_cnc.then(|| scaling(scale::manipulated(of.multi_gain)))),
        ("process data of the velocity command", in_cnc.then(|| width(of.command))),
        ("additive velocity", of.velocity.map(additive)),
        ("process data of the additive velocity", of.velocity.map(|velocity| width(velocity.width))),
        ("resolution", of.resolution.as_ref().map(resolution)),
        ("shift time", of.resolution.map(|_| Effect::Number(f64::from(of.shift_time), " cycles"))),
    ];
    of_part("position control", values)
}

/// The place of position control, in words.
pub(super) fn place(location: Location) -> &'static str {
    match location {
        Location::Cnc => "in the CNC",
        Location::Drive => "in the drive",
        Location::Profidrive => "in the drive (PROFIdrive)",
    }
}
