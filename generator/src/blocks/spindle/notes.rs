//! The physical meaning of each coefficient of the changeover. No design.

use super::super::feedforward::notes::{of_velocity, of_width};
use super::super::ipc::notes::{cycle_time, note};
use super::design::{kv, weight};
use super::limits::{ramp, window};
use crate::axis::{Axis, Changeover};
use crate::number::digits;
use crate::parameters::time_text;

/// 1 rpm [0.001 deg/s].
pub(crate) const RPM: f64 = 6000.0;

pub(crate) fn notes(axis: &Axis) -> Vec<(String, String)> {
    let Some(of) = &axis.control.spindle else { return Vec::new() };
    let [on, off] = [of.v_velocity_control_on, of.v_position_control_on].map(f64::from);
    let window = window(of.v_position_control_on, of.window);
    let delay = format!("{} cycles (P-AXIS-00191)", of.delay_cycles + 1);
    let lead = match of.only_velocity() {
        true => delay,
        false => format!("{delay} and {} / Kv, Kv = {}/s (P-AXIS-00099)", digits(1.0 - weight(of)), digits(kv(of))),
    };
    let brake = format!(
        "{}; from the largest velocity (P-AXIS-00212) the ramp takes {}",
        time_text(of.brake_timeout_ns),
        time_text(ramp(axis.ipc.v_max, off, of.deceleration))
    );
    let mut notes = vec![
        note("cycle_time_ns", cycle_time(axis)),
        note("v_velocity_control_on", format!("Von = {} rpm (P-AXIS-00767)", digits(on / RPM))),
        note("v_position_control_on", format!("Voff = {} rpm (P-AXIS-00768)", digits(off / RPM))),
        note("window", format!("{} rpm (key spindle.window)", digits(window / RPM))),
        note("v_step", format!("deceleration {} rpm/s (key spindle.deceleration)", digits(of.deceleration / RPM))),
        note("v_largest", format!("below {} rpm", digits(super::design::half_turn(axis) / RPM))),
        note("lead_time", lead),
        note("takeover_window", format!("{} deg (key spindle.takeover_window)", digits(of.takeover_window / 1000.0))),
        note("mode_cycles", format!("{} (key spindle.mode_timeout)", time_text(of.mode_timeout_ns))),
        note("brake_cycles", brake),
    ];
    match &of.drive {
        Changeover::Cnc { feedforward, .. } => notes.extend(feedforward.map(|weight| {
            let weight = digits(weight.value());
            note("lead_time_per_percent", format!("weight of the feedforward {weight} (P-AXIS-00228/00229) / 100 / Kv"))
        })),
        Changeover::Drive { velocity, .. } => {
            let [scale, _] = of_velocity(velocity, axis);
            notes.push((scale.0, scale.1.replacen("additive velocity", "velocity command", 1)));
            notes.push(note("velocity_range", of_width(velocity.width)));
        }
    }
    notes
}
