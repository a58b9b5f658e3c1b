//! The physical meaning of each coefficient of feedforward. No design.

use super::super::ipc::notes::{cycle_time, note};
use super::design::time_constant;
use crate::axis::{Axis, Feedforward, Motor, Ratio, TimeBase, Torque, Velocity, Width};
use crate::{design::scale, number::digits};

pub(crate) fn notes(axis: &Axis) -> Vec<(String, String)> {
    let Some(of) = &axis.control.feedforward else { return Vec::new() };
    let Ratio { num, denom } = of.weight;
    let weight = digits(of.weight.value());
    let weight = format!("weight of the whole feedforward {num}/{denom} = {weight} (P-AXIS-00228/00229)");
    let t_a = format!("time constant Ta = {} ms (P-AXIS-00225/00226)", digits(time_constant(of) * 1e3));
    let t_j = format!("jerk factor {}/{} (P-AXIS-00337/00338) times Ta^2", of.jerk.num, of.jerk.denom);
    let mut notes =
        vec![note("cycle_time_ns", cycle_time(axis)), note("weight", weight), note("t_a", t_a), note("t_j", t_j)];
    for (path, us, id) in [
        ("velocity_delay", of.velocity_delay, "00389"),
        ("acceleration_delay", of.acceleration_delay, "00390"),
        ("jerk_delay", of.jerk_delay, "00547"),
    ] {
        let cycles = f64::from(us) * 1000.0 / f64::from(axis.cycle_time_ns);
        notes.push(note(path, format!("delay of {us} us = {} cycles (P-AXIS-{id})", digits(cycles))));
    }
    notes.extend(of.velocity.iter().flat_map(|velocity| of_velocity(velocity, axis)));
    if let Some(torque) = &of.torque_scale {
        notes.push(note("torque_acceleration", of_torque(torque, of)));
        let jerk = "inferred from units: the jerk factor (P-AXIS-00337/00338) read in seconds".to_owned();
        notes.push(note("torque_jerk", jerk));
        notes.push(note("torque_range", of_width(torque.width)));
    }
    notes
}

/// Scaling and process data of the additive velocity.
pub(crate) fn of_velocity(velocity: &Velocity, axis: &Axis) -> [(String, String); 2] {
    let time = match velocity.time_base {
        TimeBase::Minute => "minute",
        TimeBase::Second => "second",
        TimeBase::Cycle => "cycle",
    };
    let Ratio { num, denom } = velocity.reso;
    let [_, velocity_unit] = axis.control.scaling_units();
    let path = if axis.control.is_rotary { "0.001 deg" } else { "1 um" };
    let increments = digits(scale::velocity(velocity, axis.cycle_time_ns) * 1e6 / 60.0);
    let text = format!(
        "additive velocity: {num}/{denom} increments at {path} per {time} (P-AXIS-00206/00205, 00207): {increments} for \
         {velocity_unit}"
    );
    [note("velocity_scale", text), note("velocity_range", of_width(velocity.width))]
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

/// A process datum.
pub(crate) fn of_width(width: Width) -> String {
    let bits = match width {
        Width::Int16 => 16,
        Width::Int32 => 32,
    };
    format!("process data of {bits} bits")
}
