//! Position control of an axis as named values, each in its unit, for the semantic diff.

use super::super::values::{Value, Values};
use super::design::kv;
use crate::axis::{Axis, Location};
use crate::design::scale;
use crate::parameters::words::Words;

/// Its values; none where there is no position control.
pub(crate) fn values(axis: &Axis) -> Values {
    let Some(of) = &axis.control.position_control else { return Values::new() };
    let mut values = Values::new();
    let mut line = |what: &str, value| values.push((format!("position control: {what}"), value));
    line("place", Value::Words(place(of.location).to_owned()));
    if of.kv > 0 {
        line("Kv", Value::Number(kv(of), "/s"));
    }
    if of.location == Location::Cnc {
        let scale = scale::manipulated(of.multi_gain) * 1e6 / 60.0;
        line("velocity command", Value::Number(scale, " increments at 1 m/min or 1000 deg/min"));
        line("process data of the velocity command", Value::Words(of.command.name().to_owned()));
    }
    if let Some(velocity) = &of.velocity {
        let scale = scale::velocity(velocity, axis.cycle_time_ns) * 1e6 / 60.0;
        line("additive velocity", Value::Number(scale, " increments at 1 m/min or 1000 deg/min"));
        line("process data of the additive velocity", Value::Words(velocity.width.name().to_owned()));
    }
    if let Some(resolution) = &of.resolution {
        line("resolution", Value::Number(scale::resolution(resolution) * 1e4, " increments per mm or deg"));
        line("shift time", Value::Number(f64::from(of.shift_time), " cycles"));
    }
    values
}

/// Where the position is controlled, in words.
pub(super) fn place(location: Location) -> &'static str {
    match location {
        Location::Cnc => "in the CNC",
        Location::Drive => "in the drive",
        Location::Profidrive => "in the drive (PROFIdrive)",
    }
}
