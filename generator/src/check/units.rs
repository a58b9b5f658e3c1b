//! Warnings for numbers that are probably in another unit: velocities and decelerations of spindles in rpm, Kv in 1/s.

use crate::axis::{Axis, Spindle};
use crate::config::values::{Key, key};
use crate::parameters::{Name, time_text};
use crate::{codes, number::rounded, rules::effective::Effective};
use portable::Extreme;

/// 1 rpm [0.001 deg/s], and 1 rpm/s [0.001 deg/s^2].
const RPM: f64 = 6000.0;
/// Probable units of a velocity.
const SPEED: [&str; 2] = ["rpm", "deg/s"];
/// 10 rpm, a possible threshold of a slow spindle [0.001 deg/s].
const LOW: f64 = 60_000.0;
/// Every ramp of a spindle is shorter [s].
const LONGEST_RAMP: f64 = 100.0;
/// Hardly any drive reaches a smaller window [0.001 deg/s], and no takeover a smaller one [0.001 deg].
const SMALL_WINDOW: f64 = 600.0;
const SMALL_TAKEOVER: f64 = 10.0;
/// Half a revolution [0.001 deg]: no angle is further away.
const EVERY_ANGLE: f64 = 180_000.0;
/// Every drive answers sooner [ns].
const LONGEST_ANSWER: u64 = 10_000_000_000;
/// 1/s: every axis has a larger gain [0.01/s].
const SLOW_KV: u32 = 100;
/// 1 (m/min)/mm [0.01/s].
const KV_PER_MINUTE: f64 = 1e5 / 60.0;

pub(crate) fn advise(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    kv(axis, gear, e);
    let Some(spindle) = &axis.control.spindle else { return };
    let largest = e.given((Name::VbMax, [gear, 0])).map_or(0.0, |_| axis.ipc.v_max);
    for [new, old] in [
        [Name::VVelocityControlOn, Name::VelocityPositionControlOn],
        [Name::VPositionControlOn, Name::VelocityPositionControlOff],
    ] {
        let given = [new, old].map(key).into_iter().find(|key| e.given(*key).is_some());
        let Some(at) = given else { continue };
        let value =
            if new == Name::VVelocityControlOn { spindle.v_velocity_control_on } else { spindle.v_position_control_on };
        let value = f64::from(value);
        // 0 has its own meaning. A threshold is more than 1/6000 of the largest velocity.
        if value > 0.0 && (value < RPM || value < LOW && value * RPM <= largest) {
            in_rpm(e, at, value, SPEED, "");
        }
    }
    braking(axis, spindle, e);
    windows(spindle, e);
    limits_nothing(axis, spindle, e);
}

/// Warns that a number is 6000 times too small if it was meant in rpm.
fn in_rpm(e: &mut Effective<'_>, at: Key, value: f64, [of_minute, of_second]: [&str; 2], why: &str) {
    let found = format!("{} is {value}, which is only {} {of_minute}{why}", e.title(at), rounded(value / RPM));
    let instead = format!(
        "{}, if {value} {of_minute} is meant, or {}, if {value} {of_second} is meant: the unit is 0.001 {of_second}",
        value * RPM,
        value * 1e3
    );
    e.warn(codes::SPINDLE_UNIT, at, found, instead);
}

/// Warns of a deceleration with which the spindle brakes for minutes.
fn braking(axis: &Axis, spindle: &Spindle, e: &mut Effective<'_>) {
    let at = key(Name::SpindleDeceleration);
    let way = axis.ipc.v_max - f64::from(spindle.v_position_control_on);
    let time = way / spindle.deceleration;
    if e.given(at).is_none() || time < LONGEST_RAMP {
        return;
    }
    let braking = format!(": braking from vb_max takes {} s", rounded(time));
    in_rpm(e, at, spindle.deceleration, ["rpm/s", "deg/s^2"], &braking);
}

/// Warns of windows in rpm and in degrees.
fn windows(spindle: &Spindle, e: &mut Effective<'_>) {
    let [window, takeover] = [Name::SpindleWindow, Name::SpindleTakeoverWindow].map(key);
    let least = spindle.window.larger(f64::from(spindle.v_position_control_on) / 100.0);
    if e.given(window).is_some() && least < SMALL_WINDOW {
        in_rpm(e, window, spindle.window, SPEED, "");
    }
    if e.given(takeover).is_some() && spindle.takeover_window < SMALL_TAKEOVER {
        let value = spindle.takeover_window;
        let found = format!("{} is {value}, which is only {} deg", e.title(takeover), rounded(value / 1e3));
        let instead = format!("{}, if {value} deg is meant: the unit is 0.001 deg", value * 1e3);
        e.warn(codes::SPINDLE_UNIT, takeover, found, instead);
    }
}

/// Warns of limits of the changeover that are so large that they limit nothing.
fn limits_nothing(axis: &Axis, spindle: &Spindle, e: &mut Effective<'_>) {
    let [deceleration, takeover, timeout] =
        [Name::SpindleDeceleration, Name::SpindleTakeoverWindow, Name::SpindleModeTimeout].map(key);
    let mut warn = |at: Key, is_beyond: bool, value: String, effect: &str, instead: &str| {
        if is_beyond && e.given(at).is_some() {
            let found = format!("{} is {value}: {effect}", e.title(at));
            e.warn(codes::LIMITS_NOTHING, at, found, instead.to_owned());
        }
    };
    warn(
        deceleration,
        spindle.deceleration * axis.cycle_time() >= axis.ipc.v_max,
        spindle.deceleration.to_string(),
        "the velocity command goes from vb_max to 0 in one cycle",
        "the deceleration of the machine: 6000000 is 1000 rpm/s",
    );
    warn(
        takeover,
        spindle.takeover_window >= EVERY_ANGLE,
        spindle.takeover_window.to_string(),
        "no step of the position command is larger, so that error 46 never occurs",
        "a smaller angle: 1000 is 1 deg",
    );
    warn(
        timeout,
        spindle.mode_timeout_ns > LONGEST_ANSWER,
        time_text(spindle.mode_timeout_ns),
        "a drive that does not change its mode is not noticed before",
        "spindle.mode_timeout = \"0.1s\"",
    );
}

/// Warns of a gain of the position controller in 1/s.
fn kv(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    let at = (Name::Kv, [gear, 0]);
    let Some(kv) = axis.control.kv.filter(|kv| *kv < SLOW_KV && e.given(at).is_some()) else { return };
    let (per_second, unit) = (f64::from(kv) / 100.0, if axis.control.is_rotary { "deg" } else { "mm" });
    let found = format!(
        "{} is {kv}, which is only {per_second}/s: at vb_max {} the axis lags by {} {unit}",
        e.title(at),
        axis.ipc.v_max,
        rounded(axis.ipc.v_max / per_second / 1e3)
    );
    let of_minute = match axis.control.is_rotary {
        true => String::new(),
        false => format!(", or {}, if {kv} (m/min)/mm is meant", libm::round(f64::from(kv) * KV_PER_MINUTE)),
    };
    let instead = format!("{}, if {kv}/s is meant{of_minute}: the unit is 0.01/s", kv * 100);
    e.warn(codes::KV_UNIT, at, found, instead);
}
