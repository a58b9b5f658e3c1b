//! The effect of the changeover of a spindle in words: its speeds, its duration, requirements on the drive.

use super::limits::{ramp, rpm, window};
use super::offered::{objects, one_of, settings};
use crate::axis::{Axis, Bus, Changeover, Spindle};
use crate::number::digits;
use crate::parameters::time_text;
use crate::parameters::words::{DriveSetting, Words};
use portable::Extreme;

/// The lines of the changeover.
pub(crate) fn lines(axis: &Axis) -> Vec<String> {
    let Some(spindle) = &axis.control.spindle else { return Vec::new() };
    let mut lines = vec![speeds(spindle), who(spindle), brake(axis, spindle)];
    if spindle.only_velocity() {
        lines = vec![ALONE.to_owned(), brake(axis, spindle)];
    } else if spindle.v_velocity_control_on == 0 {
        lines.push(SENSORLESS.to_owned());
    } else {
        lines.push(lag(axis, spindle));
    }
    if let Changeover::Drive { bus, velocity_mode, .. } = spindle.drive {
        lines.extend(needs(bus, velocity_mode, spindle.only_velocity()));
    }
    lines
}

/// The lag at which the gain of a loop in the CNC is measured, well below half a revolution [0.001 deg].
const MEASURED_LAG: f64 = 60_000.0;

const SENSORLESS: &str = "velocity control at every speed, as a spindle without a position sensor needs it; M19, S[PUTAX], G74 and reset \
                          lead to position control";

const ALONE: &str = "velocity control alone: v_velocity_control_on and v_position_control_on are 0, and the drive has no position control; \
                     M19, S[PUTAX] and G74 are refused (error_id 49)";

/// A velocity [0.001 deg/s] in a form for readers.
fn speed(velocity: f64) -> String {
    format!("{} rpm ({} deg/s)", rpm(velocity), digits(velocity / 1000.0))
}

fn speeds(spindle: &Spindle) -> String {
    let [on, off] = [spindle.v_velocity_control_on, spindle.v_position_control_on].map(|of| speed(f64::from(of)));
    let window = rpm(window(spindle.v_position_control_on, spindle.window));
    format!("changeover: M3 and M4 above {on} lead to velocity control, back at {off} within {window} rpm")
}

fn who(spindle: &Spindle) -> String {
    let timeout = time_text(spindle.mode_timeout_ns);
    match spindle.drive {
        Changeover::Cnc => {
            "the CNC opens and closes its position loop, within a cycle; the drive stays in velocity control".to_owned()
        }
        Changeover::Drive { bus, position_mode, velocity_mode, .. } => {
            let of = match bus {
                Bus::Sercos => "SERCOS: 0 is S-0-0032, 1 to 3 are S-0-0033 to S-0-0035",
                Bus::CanOpen => "CANopen: 6060h and 6061h",
            };
            format!(
                "the drive changes from mode {position_mode}, position control, to mode {velocity_mode}, velocity control, and back, \
                 within {timeout} each ({of})"
            )
        }
    }
}

fn brake(axis: &Axis, spindle: &Spindle) -> String {
    let largest = axis.ipc.v_max;
    let ramp = ramp(largest, f64::from(spindle.v_position_control_on), spindle.deceleration);
    format!(
        "it brakes by {} rpm/s: from vb_max, {}, in {}, or it stops with an error after {}",
        rpm(spindle.deceleration),
        speed(largest),
        time_text(ramp),
        time_text(spindle.brake_timeout_ns)
    )
}

/// The position lag (1 - w) v / Kv, to be measured once: at the velocity at which position control ends. In the CNC the velocity
/// is lower if the lag without feedforward would be an error.
fn lag(axis: &Axis, spindle: &Spindle) -> String {
    let kv = f64::from(spindle.kv) / 100.0;
    let mut largest = f64::from(spindle.v_velocity_control_on).smaller(axis.ipc.v_max);
    if let Changeover::Cnc = spindle.drive {
        largest = largest.smaller(MEASURED_LAG * kv);
    }
    let lag = |weight: f64| digits((1.0 - weight) * largest / 1000.0 / kv);
    let (speed, kv) = (rpm(largest), digits(kv));
    let cycles = spindle.delay_cycles;
    match &spindle.drive {
        Changeover::Cnc => format!(
            "without feedforward the position lag at {speed} rpm must be {} deg, within 1 %: else P-AXIS-00129/00128 do not scale the velocity \
             command as the drive does (Kv {kv}/s)",
            lag(0.0)
        ),
        Changeover::Drive { bus, feed_forward_v_weighting, .. } => {
            let weight = f64::from(*feed_forward_v_weighting) / 1000.0;
            let [of_gain, of_weight] = match bus {
                Bus::Sercos => ["S-0-0104", "S-0-0296"],
                Bus::CanOpen => ["30C0h:01", "3062h"],
            };
            format!(
                "the position lag at {speed} rpm must be {} deg: Kv {kv}/s ({of_gain}), {} % feedforward ({of_weight}), {cycles} delay cycles",
                lag(weight),
                digits(weight * 100.0)
            )
        }
    }
}

fn needs(bus: Bus, velocity_mode: i32, is_alone: bool) -> Vec<String> {
    let of_telegram: Vec<String> =
        objects(bus, is_alone).iter().map(|(words, what)| format!("{} {what}", one_of(words))).collect();
    let mut lines =
        vec![format!("the drive must have in its cyclic telegram (process_data.objects): {}", of_telegram.join(", "))];
    let settings = settings(bus, velocity_mode, is_alone);
    if !settings.is_empty() {
        let setting = |(words, what): &(&[DriveSetting], &str)| format!("{} {what}", words[0].name());
        let settings: Vec<String> = settings.iter().map(setting).collect();
        lines.push(format!("and these settings (drive_settings; 010: bits 2 to 0): {}", settings.join(", ")));
    }
    lines
}
