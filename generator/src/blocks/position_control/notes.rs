//! The physical meaning of each coefficient of position control. No design.

use super::super::feedforward::notes::{of_velocity, of_width};
use super::super::ipc::notes::{cycle_time, note};
use super::design::kv;
use crate::axis::{Axis, Location, Ratio};
use crate::{design::scale, number::digits};

pub(crate) fn notes(axis: &Axis) -> Vec<(String, String)> {
    let Some(of) = &axis.control.position_control else { return Vec::new() };
    let mut notes = vec![note("cycle_time_ns", cycle_time(axis))];
    let kv = digits(kv(of));
    match of.location {
        Location::Cnc => {
            notes.push(note("kv", format!("position control in the CNC: Kv = {kv}/s (P-AXIS-00099)")));
            let Ratio { num, denom } = of.multi_gain;
            let [_, velocity] = axis.control.scaling_units();
            let gain = format!("{num}/{denom} increments at {velocity} (P-AXIS-00129/00128)");
            notes.push(note("manipulated_scale", gain));
            notes.push(note("manipulated_range", of_width(of.command)));
        }
        Location::Drive | Location::Profidrive => {
            let check = "the drive must have the same Kv (SERCOS S-0-0104 in 1000/min, CANopen 30C0h:01 in 1/s)";
            notes.push(note("lag", format!("1/Kv, Kv = {kv}/s (P-AXIS-00099): {check}")));
        }
    }
    if let Some(resolution) = &of.resolution {
        let increments = digits(scale::resolution(resolution));
        let [fine, _] = axis.control.scaling_units();
        let text = format!(
            "path resolution R = {increments} increments per {fine} (P-AXIS-00092, 00233, 00234, 00362, 00363)"
        );
        notes.push(note("xerr_scale", text));
    }
    notes.extend(of.velocity.iter().flat_map(|velocity| of_velocity(velocity, axis)));
    notes
}
