//! The physical meaning of each coefficient of the changeover. No design.

use super::super::feedforward::notes::of_velocity;
use super::super::ipc::notes::{cycle_time, note};
use super::design::{kv, weight};
use super::limits::{ramp, window};
use crate::axis::{Axis, Bus, Changeover, Spindle};
use crate::number::digits;
use crate::parameters::time_text;

/// 1 rpm [0.001 deg/s].
pub(crate) const RPM: f64 = 6000.0;

pub(crate) fn notes(axis: &Axis) -> Vec<(String, String)> {
    let Some(of) = &axis.control.spindle else { return Vec::new() };
    let [on, off] = [of.v_velocity_control_on, of.v_position_control_on].map(f64::from);
    let window = window(of.v_position_control_on, of.window);
    let timeout = time_text(of.mode_timeout_ns);
    let brake = format!(
        "{} (key spindle.brake_timeout); from the largest velocity (P-AXIS-00212) the ramp takes {}",
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
        note("lead_time", lead(of)),
        note("takeover_window", format!("{} deg (key spindle.takeover_window)", digits(of.takeover_window / 1000.0))),
        note("mode_cycles", format!("{timeout} (key spindle.mode_timeout)")),
        note("start_cycles", format!("{timeout} (key spindle.mode_timeout) and two cycles")),
        note("brake_cycles", brake),
    ];
    notes.extend(of.feedforward.map(|weight| {
        let weight = digits(weight.value());
        note("lead_time_per_percent", format!("weight of the feedforward {weight} (P-AXIS-00228/00229) / 100 / Kv"))
    }));
    notes.extend(of_drive(of, axis));
    notes
}

/// The notes of a changeover in the drive; none in the CNC.
fn of_drive(of: &Spindle, axis: &Axis) -> Vec<(String, String)> {
    let (velocity, bus) = match &of.drive {
        Changeover::Cnc => return Vec::new(),
        Changeover::Drive { velocity, bus, .. } => (velocity, bus),
    };
    let modes = match bus {
        Bus::Sercos => "operation modes of the drive, as in S-0-0134 (P-AXIS-00264)",
        Bus::CanOpen => "operation modes of the drive, as in 6060h (P-AXIS-00463, 00464)",
    };
    let [(scale, text), range] = of_velocity(velocity, axis);
    let text = text.replacen("additive velocity", "velocity command", 1);
    vec![note("position_mode", modes.to_owned()), (scale, text), range]
}

/// The terms of the lead of the position command.
fn lead(of: &Spindle) -> String {
    let delay = format!("Nd + 1 = {} cycles (P-AXIS-00191)", of.delay_cycles + 1);
    let kv = format!("Kv = {}/s (P-AXIS-00099)", digits(kv(of)));
    let shorter = if of.feedforward.is_some() { "; an active feedforward shortens it" } else { "" };
    match of.drive {
        Changeover::Cnc => format!("T + 1 / Kv, {kv}{shorter}"),
        Changeover::Drive { .. } if of.only_velocity() => format!("(Nd + 1) T, {delay}"),
        Changeover::Drive { .. } => {
            let weight = digits(weight(of));
            format!("(Nd + 1) T + (1 - w) / Kv, {delay}, w = {weight} (P-AXIS-00833, 00766), {kv}{shorter}")
        }
    }
}
