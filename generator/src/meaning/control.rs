//! What differs in feedforward, position control and gantry: quantities, weights, times, scalings, each in its unit.

use super::axis::same;
use super::number::{pair, significant};
use crate::axis::{Axis, Feedforward, Place, PositionControl, Width};
use crate::block;
use crate::design::{control_notes::quantities, feedforward::time_constant, position_control::kv, scale};

/// A line for each value that differs.
pub fn differences(old: &Axis, new: &Axis) -> Vec<String> {
    let (before, after) = (lines(old), lines(new));
    let mut differences = Vec::new();
    for (what, value) in &before {
        let other = after.iter().find(|(name, _)| name == what).map(|(_, value)| value);
        match other {
            Some(other) if value.is_same(other) => {}
            Some(other) => differences.push(format!("{what} {}", value.to(other))),
            None => differences.push(format!("{what} {} -> none", value.text())),
        }
    }
    for (what, value) in after.iter().filter(|(what, _)| before.iter().all(|(name, _)| name != what)) {
        differences.push(format!("{what} none -> {}", value.text()));
    }
    differences
}

/// All values, of an axis that there was no other of.
pub fn described(axis: &Axis) -> Vec<String> {
    lines(axis).into_iter().skip(1).map(|(what, value)| format!("{what} {}", value.text())).collect()
}

/// A value with its unit, or words.
enum Value {
    Number(f64, &'static str),
    Words(String),
}

impl Value {
    fn text(&self) -> String {
        match self {
            Self::Number(value, unit) => format!("{}{unit}", significant(*value, 7)),
            Self::Words(words) => words.clone(),
        }
    }

    fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number(a, _), Self::Number(b, _)) => same(*a, *b),
            _ => self.text() == other.text(),
        }
    }

    fn to(&self, other: &Self) -> String {
        match (self, other) {
            (Self::Number(a, unit), Self::Number(b, _)) => format!("{}{unit}", pair(*a, *b, 7)),
            _ => format!("{} -> {}", self.text(), other.text()),
        }
    }
}

/// Every value by its name; the blocks first.
fn lines(axis: &Axis) -> Vec<(String, Value)> {
    let mut lines = vec![("blocks".to_owned(), Value::Words(block::names(axis).join(", ")))];
    if let Some(of) = &axis.control.feedforward {
        feedforward(of, axis, &mut |what, value| lines.push((format!("feedforward: {what}"), value)));
    }
    if let Some(of) = &axis.control.position_control {
        position_control(of, axis, &mut |what, value| lines.push((format!("position control: {what}"), value)));
    }
    if let Some(limit) = axis.control.master_limit {
        lines.push(("gantry: limit of the master".to_owned(), Value::Number(limit, "")));
    }
    lines
}

fn feedforward(of: &Feedforward, axis: &Axis, line: &mut dyn FnMut(&str, Value)) {
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
        let words = if of.global_disable { "never" } else { "always" };
        line("active", Value::Words(words.to_owned()));
    }
    line("weight", Value::Number(of.weight.value() * 100.0, " %"));
    let sums = [of.conventional, of.additive];
    if sums.iter().any(|sum| sum.acceleration || sum.jerk) {
        line("time constant", Value::Number(time_constant(of) * 1e3, " ms"));
    }
    if sums.iter().any(|sum| sum.jerk) || of.torque.jerk {
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
        line("process data of the torque", width(torque.width));
    }
}

fn position_control(of: &PositionControl, axis: &Axis, line: &mut dyn FnMut(&str, Value)) {
    let place = match of.place {
        Place::Cnc => "in the CNC",
        Place::Drive => "in the drive",
        Place::Profidrive => "in the drive (PROFIdrive)",
    };
    line("place", Value::Words(place.to_owned()));
    if of.kv > 0 {
        line("Kv", Value::Number(kv(of), "/s"));
    }
    if of.place == Place::Cnc {
        let scale = scale::manipulated(of.multi_gain) * 1e6 / 60.0;
        line("velocity command", Value::Number(scale, " increments at 1 m/min or 1000 deg/min"));
        line("process data of the velocity command", width(of.command));
    }
    if let Some(velocity) = &of.velocity {
        let scale = scale::velocity(velocity, axis.cycle_time_ns) * 1e6 / 60.0;
        line("additive velocity", Value::Number(scale, " increments at 1 m/min or 1000 deg/min"));
        line("process data of the additive velocity", width(velocity.width));
    }
    if let Some(resolution) = &of.resolution {
        line("resolution", Value::Number(scale::resolution(resolution) * 1e4, " increments per mm or deg"));
        line("shift time", Value::Number(f64::from(of.shift_time), " cycles"));
    }
}

fn width(width: Width) -> Value {
    let words = match width {
        Width::Int16 => "INT16",
        Width::Int32 => "INT32",
    };
    Value::Words(words.to_owned())
}
