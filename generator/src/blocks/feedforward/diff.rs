//! Feedforward of an axis as named values, each in its unit, for the semantic diff.

use super::super::values::{Value, Values, of_part};
use super::{design::time_constant, summary::quantities};
use crate::axis::{Axis, Quantities, Torque};
use crate::{design::scale, parameters::words::Words};

/// Its values; none where there is no feedforward.
pub(crate) fn values(axis: &Axis) -> Values {
    let Some(of) = &axis.control.feedforward else { return Values::new() };
    let way = |way: Quantities| way.any().then(|| Value::Words(quantities(way)));
    let active = if of.global_disable { "never" } else { "always" };
    let delay = |is_used: bool, us: u32| is_used.then(|| Value::Number(f64::from(us), " us"));
    let per_velocity = of.velocity.map(|velocity| scale::velocity(&velocity, axis.cycle_time_ns) * 1e6 / 60.0);
    let torque = |torque: &Torque| Value::Number(scale::torque(torque) * 1e6, " increments at 1 m/s^2 or 1000 deg/s^2");
    let width = |torque: &Torque| Value::Words(torque.width.name().to_owned());
    let has_jerk = of.sums().jerk || of.torque.jerk;
    let values = [
        ("to the position controller", way(of.conventional)),
        ("as additive velocity", way(of.additive)),
        ("as additive torque", way(of.torque)),
        ("active", (of.global_disable || of.default_active).then(|| Value::Words(active.to_owned()))),
        ("weight", Some(Value::Number(of.weight.value() * 100.0, " %"))),
        ("time constant", of.sums().use_time().then(|| Value::Number(time_constant(of) * 1e3, " ms"))),
        ("jerk factor", has_jerk.then(|| Value::Number(of.jerk.value(), ""))),
        ("weight of the torque", of.torque.acceleration.then(|| Value::Number(of.acceleration.value() * 100.0, " %"))),
        ("delay of the velocity", delay(of.additive.any(), of.velocity_delay)),
        ("delay of the torque", delay(of.torque.acceleration, of.acceleration_delay)),
        ("delay of the jerk", delay(of.torque.jerk, of.jerk_delay)),
        ("additive velocity", per_velocity.map(|x| Value::Number(x, " increments at 1 m/min or 1000 deg/min"))),
        ("additive torque", of.torque_scale.as_ref().map(torque)),
        ("process data of the torque", of.torque_scale.as_ref().map(width)),
    ];
    of_part("feedforward", values)
}
