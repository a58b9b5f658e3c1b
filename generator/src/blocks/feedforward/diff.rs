//! Feedforward of an axis as named values, each in its unit, for the semantic diff.

use super::super::values::{Value, Values};
use super::design::time_constant;
use super::summary::quantities;
use crate::axis::Axis;
use crate::design::scale;
use crate::parameters::words::Words;

/// Its values; none where there is no feedforward.
pub(crate) fn values(axis: &Axis) -> Values {
    let Some(of) = &axis.control.feedforward else { return Values::new() };
    let mut values = Values::new();
    let mut line = |what: &str, value| values.push((format!("feedforward: {what}"), value));
    for (way, what) in [
        ("to the position controller", of.conventional),
        ("as additive velocity", of.additive),
        ("as additive torque", of.torque),
    ] {
        if what.any() {
            line(way, Value::Words(quantities(what)));
        }
    }
    if of.global_disable || of.default_active {
        line("active", Value::Words(if of.global_disable { "never" } else { "always" }.to_owned()));
    }
    line("weight", Value::Number(of.weight.value() * 100.0, " %"));
    if of.sums().use_time() {
        line("time constant", Value::Number(time_constant(of) * 1e3, " ms"));
    }
    if of.sums().jerk || of.torque.jerk {
        line("jerk factor", Value::Number(of.jerk.value(), ""));
    }
    if of.torque.acceleration {
        line("weight of the torque", Value::Number(of.acceleration.value() * 100.0, " %"));
    }
    for (is_used, what, us) in [
        (of.additive.any(), "delay of the velocity", of.velocity_delay),
        (of.torque.acceleration, "delay of the torque", of.acceleration_delay),
        (of.torque.jerk, "delay of the jerk", of.jerk_delay),
    ] {
        if is_used {
            line(what, Value::Number(f64::from(us), " us"));
        }
    }
    if let Some(velocity) = &of.velocity {
        let scale = scale::velocity(velocity, axis.cycle_time_ns) * 1e6 / 60.0;
        line("additive velocity", Value::Number(scale, " increments at 1 m/min or 1000 deg/min"));
    }
    if let Some(torque) = &of.torque_scale {
        line("additive torque", Value::Number(scale::torque(torque) * 1e6, " increments at 1 m/s^2 or 1000 deg/s^2"));
        line("process data of the torque", Value::Words(torque.width.name().to_owned()));
    }
    values
}
