//! What each coefficient of feedforward, position control and the whole axis means physically. No design.

use super::{digits, feedforward as design, notes, position_control as control, scale};
use crate::axis::{Axis, Feedforward, Motor, Place, PositionControl, Quantities, Torque, Velocity, Width};
use reference::feedforward::Coeffs;

/// Notes on feedforward.
#[must_use]
pub fn feedforward(axis: &Axis) -> Vec<(String, String)> {
    let Some(of) = &axis.control.feedforward else { return Vec::new() };
    let mut notes = vec![note("cycle_time_ns", cycle_time(axis))];
    notes.push(note("weight", of_weight(of)));
    notes.push(note("t_a", of_time(of)));
    notes.push(note("t_j", of_jerk(of)));
    for (path, us, id) in [
        ("velocity_delay", of.velocity_delay, "00389"),
        ("acceleration_delay", of.acceleration_delay, "00390"),
        ("jerk_delay", of.jerk_delay, "00547"),
    ] {
        let cycles = f64::from(us) * 1000.0 / f64::from(axis.cycle_time_ns);
        notes.push(note(path, format!("delay of {us} us = {} cycles (P-AXIS-{id})", digits(cycles))));
    }
    if let Some(velocity) = &of.velocity {
        notes.push(note("velocity_scale", of_velocity(velocity, axis.cycle_time_ns)));
        notes.push(note("velocity_range", of_width(velocity.width)));
    }
    if let Some(torque) = &of.torque_scale {
        notes.push(note("torque_acceleration", of_torque(torque, of)));
        notes.push(note(
            "torque_jerk",
            "inferred from units: the jerk factor (P-AXIS-00337/00338) read in seconds".to_owned(),
        ));
        notes.push(note("torque_range", of_width(torque.width)));
    }
    notes
}

/// Notes on position control.
#[must_use]
pub fn position_control(axis: &Axis) -> Vec<(String, String)> {
    let Some(of) = &axis.control.position_control else { return Vec::new() };
    let mut notes = vec![note("cycle_time_ns", cycle_time(axis))];
    let kv = digits(control::kv(of));
    match of.place {
        Place::Cnc => {
            notes.push(note("kv", format!("position control in the CNC: Kv = {kv}/s (P-AXIS-00099)")));
            notes.push(note("manipulated_scale", of_gain(of)));
            notes.push(note("manipulated_range", of_width(of.command)));
        }
        Place::Drive | Place::Profidrive => {
            let check = "the drive must have the same (SERCOS S-0-0104, CANopen 30C0h:01)";
            notes.push(note("lag", format!("1/Kv, Kv = {kv}/s (P-AXIS-00099): {check}")));
        }
    }
    if let Some(resolution) = &of.resolution {
        let increments = digits(scale::resolution(resolution));
        let text = format!(
            "path resolution R = {increments} increments per 0.1 um or 0.0001 deg (P-AXIS-00092, 00233, 00234, 00362, 00363)"
        );
        notes.push(note("xerr_scale", text));
    }
    if let Some(velocity) = &of.velocity {
        notes.push(note("velocity_scale", of_velocity(velocity, axis.cycle_time_ns)));
        notes.push(note("velocity_range", of_width(velocity.width)));
    }
    notes
}

/// Notes on the whole axis: those of its parts.
#[must_use]
pub fn axis(axis: &Axis) -> Vec<(String, String)> {
    let within = |part: &'static str, notes: Vec<(String, String)>| {
        notes.into_iter().map(move |(path, text)| (format!("{part}.{path}"), text))
    };
    let mut notes = vec![note("cycle_time_ns", cycle_time(axis))];
    if let Some(limit) = axis.control.master_limit {
        let text = format!("largest |v_add| = {} of the gantry's master (P-AXIS-00070, 00757, 00212)", digits(limit));
        notes.push(note("master_limit", text));
    }
    notes.extend(within("feedforward", feedforward(axis)));
    notes.extend(within("ipc", notes::notes(axis)));
    notes.extend(within("position_control", position_control(axis)));
    notes
}

/// The noise on an acceleration at which the additive torque is cut off; without one no bound.
#[must_use]
pub fn largest_torque(coeffs: &Coeffs<f64>) -> f64 {
    let factor = coeffs.torque_acceleration.max(coeffs.torque_jerk) * coeffs.weight;
    if factor > 0.0 { (f64::from(coeffs.torque_range.highest) / factor).clamp(1e-6, 1e7) } else { 1e7 }
}

fn cycle_time(axis: &Axis) -> String {
    format!("cycle time {} us, the coefficients hold for no other", digits(f64::from(axis.cycle_time_ns) / 1000.0))
}

fn of_weight(of: &Feedforward) -> String {
    format!(
        "weight of the whole feedforward {}/{} = {} (P-AXIS-00228/00229)",
        of.weight.num,
        of.weight.denom,
        digits(of.weight.value())
    )
}

fn of_time(of: &Feedforward) -> String {
    format!("time constant Ta = {} ms (P-AXIS-00225/00226)", digits(design::time_constant(of) * 1e3))
}

fn of_jerk(of: &Feedforward) -> String {
    format!("jerk factor {}/{} (P-AXIS-00337/00338) times Ta^2", of.jerk.num, of.jerk.denom)
}

fn of_velocity(velocity: &Velocity, cycle_time_ns: u32) -> String {
    let time = match velocity.time_base {
        crate::axis::TimeBase::Minute => "minute",
        crate::axis::TimeBase::Second => "second",
        crate::axis::TimeBase::Cycle => "cycle",
    };
    format!(
        "additive velocity: {} increments at {} um or 0.001 deg per {time} (P-AXIS-00206/00205, 00207): {} for 1 m/min or 1000 deg/min",
        velocity.reso.num,
        velocity.reso.denom,
        digits(scale::velocity(velocity, cycle_time_ns) * 1e6 / 60.0)
    )
}

fn of_gain(of: &PositionControl) -> String {
    format!("{}/{} increments at 1 m/min or 1000 deg/min (P-AXIS-00129/00128)", of.multi_gain.num, of.multi_gain.denom)
}

fn of_torque(torque: &Torque, of: &Feedforward) -> String {
    let nominal = digits(torque.scale.value());
    let (load, unit, reference) = match torque.motor {
        Motor::Rotary => ("kg m^2", "Nm", "nominal torque"),
        Motor::Linear => ("kg", "N", "nominal force"),
    };
    let weight = digits(of.acceleration.value());
    format!(
        "additive torque: load {} {load} (P-AXIS-00391), {nominal} increments (P-AXIS-00325/00326) at the {reference} {} {unit} \
         (P-AXIS-00392), weight {weight} (P-AXIS-00225/00226)",
        digits(torque.load),
        digits(torque.reference)
    )
}

fn of_width(width: Width) -> String {
    let bits = match width {
        Width::Int16 => 16,
        Width::Int32 => 32,
    };
    format!("process data of {bits} bits")
}

/// Which quantities a sum has, in words.
#[must_use]
pub fn quantities(of: Quantities) -> String {
    let named = [(of.velocity, "velocity"), (of.acceleration, "acceleration"), (of.jerk, "jerk")];
    let there: Vec<&str> = named.into_iter().filter(|(is, _)| *is).map(|(_, name)| name).collect();
    there.join(", ")
}

fn note(path: &str, text: String) -> (String, String) {
    (path.to_owned(), text)
}
