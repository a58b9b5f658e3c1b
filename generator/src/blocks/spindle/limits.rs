//! Limits from the cycle time and the deceleration: half a revolution per cycle, and the times of the changeover.

use super::velocities::{Velocities, asks};
use crate::axis::Location;
use crate::config::values::{Key, key};
use crate::diagnostics::{Diagnostic, Place};
use crate::parameters::{Name, time_text};
use crate::rules::effective::Effective;
use crate::{codes, number::rounded};
use portable::Extreme;

/// Half a revolution [0.001 deg]: a drive cannot detect the direction of a longer movement.
const HALF_A_REVOLUTION: f64 = 180_000.0;
/// The largest count that is exact in single precision.
const MOST_CYCLES: u64 = 1 << 24;
/// Cycles after the drive's answer in the default of the mode timeout.
const MODE_RESERVE: u64 = 10;
/// Added to twice the ramp in the default of the brake timeout [ns].
const BRAKE_RESERVE: u64 = 500_000_000;

/// 0.001 deg/s as revolutions per minute.
pub(super) fn rpm(velocity: f64) -> f64 {
    rounded(velocity / 6000.0)
}

/// Half the width of the window around the velocity of position control [0.001 deg/s].
pub(super) fn window(off: u32, least: f64) -> f64 {
    (f64::from(off) / 100.0).larger(least)
}

/// The times within which the drive displays a new mode and the spindle has braked [ns]. Checks them, and the
/// velocities of a drive that controls the position; `is_alone` marks a drive with velocity control alone.
pub(super) fn check(
    e: &mut Effective<'_>,
    (location, cycle_time): (Location, Option<u32>),
    (velocities, is_alone): (Option<Velocities>, bool),
    [window, deceleration]: [Option<f64>; 2],
    delay_cycles: Option<u32>,
) -> [Option<u64>; 2] {
    let all = velocities.as_ref();
    let in_drive = cycle_time.filter(|_| location != Location::Cnc);
    if let (Some(ns), Some(of), Some(window)) = (in_drive, all, window) {
        half_a_revolution(e, ns, of, window);
    }
    let mode = mode_timeout(e, cycle_time, delay_cycles);
    let changing = all.filter(|_| !is_alone);
    if let (Some(ns), Some(of), Some(a), Some(timeout)) = (in_drive, changing, deceleration, mode) {
        accelerates_beyond(e, ns, of, a, timeout);
    }
    [mode, brake_timeout(e, cycle_time, all, deceleration)]
}

/// A spindle without a changeover whose drive controls the position: checks its largest velocity, if given.
pub(crate) fn half_a_revolution_at_most(e: &mut Effective<'_>, cycle_ns: u32, largest: Key) {
    let Some(velocity) = e.given(largest).and_then(|_| e.validated_integer(largest)) else { return };
    let cycle = f64::from(cycle_ns);
    if f64::from(velocity) * cycle < HALF_A_REVOLUTION * 1e9 {
        return;
    }
    let found = format!(
        "in position control the spindle turns with up to {} rpm: {} is {velocity}",
        rpm(f64::from(velocity)),
        e.title(largest)
    );
    let instead = "a lower vb_max, a shorter cycle, or v_velocity_control_on: 200 rpm are 1200000";
    beyond(e, e.place_of(largest), cycle_ns, found, instead);
}

/// Rejects a velocity of half a revolution in a cycle, or more.
fn beyond(e: &mut Effective<'_>, place: Place, cycle_ns: u32, found: String, instead: &str) {
    let end = HALF_A_REVOLUTION * 1e9 / f64::from(cycle_ns);
    let allowed = format!(
        "less than half a revolution in a cycle: below {} rpm, {} [0.001 deg/s], at a cycle time of {}",
        rpm(end),
        rounded(end),
        time_text(u64::from(cycle_ns))
    );
    e.report.push(Diagnostic::error(codes::HALF_A_REVOLUTION, place, found).allowed(allowed).instead(instead));
}

/// A drive that controls the position must turn by less than half a revolution per cycle.
fn half_a_revolution(e: &mut Effective<'_>, cycle_ns: u32, of: &Velocities, least_window: f64) {
    let cycle = f64::from(cycle_ns);
    // In nanoseconds, where 15000 rpm and 2 ms make exactly half a revolution.
    let is_beyond = |velocity: f64| velocity * cycle >= HALF_A_REVOLUTION * 1e9;
    let window = window(of.off.value, least_window);
    let taken_up = f64::from(of.off.value) + window;
    if is_beyond(taken_up) {
        let found = format!(
            "{} is {}: with its window of {} rpm the drive takes up position control at up to {} rpm",
            e.title(of.off.key),
            of.off.value,
            rpm(window),
            rpm(taken_up)
        );
        let at = if e.given(of.off.key).is_some() { of.off.key } else { key(Name::SpindleWindow) };
        let instead = "a lower v_position_control_on or spindle.window: 50 rpm are 300000";
        beyond(e, e.place_near(at, asks), cycle_ns, found, instead);
    }
    let (lower, higher) = if of.on.value <= of.largest.value { (of.on, of.largest) } else { (of.largest, of.on) };
    if is_beyond(f64::from(lower.value)) {
        let found = format!(
            "in position control the spindle turns with up to {} rpm: {} is {}, {} is {}",
            rpm(f64::from(lower.value)),
            e.title(lower.key),
            lower.value,
            e.title(higher.key),
            higher.value
        );
        let at = if e.given(lower.key).is_some() { lower.key } else { higher.key };
        let instead = "a lower v_velocity_control_on: 200 rpm are 1200000";
        beyond(e, e.place_near(at, asks), cycle_ns, found, instead);
    }
}

/// Warns of a velocity of the changeover near half a revolution per cycle: until the drive displays velocity control, it is
/// under position control, and the spindle accelerates. Von is passed by up to a cycle's velocity, and the last permitted cycle
/// begins when the time is over.
fn accelerates_beyond(e: &mut Effective<'_>, cycle_ns: u32, of: &Velocities, deceleration: f64, ns: u64) {
    let end = HALF_A_REVOLUTION * 1e9 / f64::from(cycle_ns);
    let on = f64::from(of.on.value);
    let gained = deceleration * (ns + 2 * u64::from(cycle_ns)) as f64 / 1e9;
    let reached = (on + gained).smaller(f64::from(of.largest.value));
    if on >= end || reached < end {
        return;
    }
    let at = if e.given(of.on.key).is_some() { of.on.key } else { of.off.key };
    let found = format!(
        "{} is {}: with {} rpm/s (spindle.deceleration) the spindle turns with {} rpm when the time of the drive's answer, {}, \
         is over, and from {} rpm it stops with error 44",
        e.title(of.on.key),
        of.on.value,
        rpm(deceleration),
        rpm(reached),
        time_text(ns),
        rpm(end)
    );
    let lower = (end - gained).ceil() - 1.0;
    let is_possible = lower >= f64::from(of.off.value) && lower > 0.0;
    let lower = is_possible.then(|| format!("v_velocity_control_on {lower} or less, "));
    let said = Diagnostic::warning(codes::ACCELERATES_BEYOND, e.place_near(at, asks), found);
    let instead = "a shorter cycle, or the time that the drive needs at spindle.mode_timeout";
    e.report.push(said.instead(lower.unwrap_or_default() + instead));
}

/// The time within which the drive displays the new mode [ns]: at least until its answer can arrive, and by default 10 cycles
/// more.
fn mode_timeout(e: &mut Effective<'_>, cycle_time: Option<u32>, answer_cycles: Option<u32>) -> Option<u64> {
    let timeout_key = key(Name::SpindleModeTimeout);
    let mut timeout = e.duration(timeout_key)?;
    let Some(cycle) = cycle_time.map(u64::from) else { return Some(timeout) };
    let answer = u64::from(answer_cycles.unwrap_or(0)) * cycle;
    if e.given(timeout_key).is_none() {
        timeout = timeout.max(answer + MODE_RESERVE * cycle);
    }
    if timeout < answer {
        let found = format!(
            "{} is {}, and the drive's answer takes {} (P-AXIS-00191)",
            e.title(timeout_key),
            time_text(timeout),
            time_text(answer)
        );
        let said = Diagnostic::error(codes::TOO_SHORT, e.place_of(timeout_key), found);
        e.report.push(
            said.allowed(format!("{} <= mode_timeout", time_text(answer))).instead("spindle.mode_timeout = \"0.1s\""),
        );
    }
    countable(e, Name::SpindleModeTimeout, timeout, cycle);
    Some(timeout)
}

/// The time within which the spindle has braked [ns]: at least its ramp; by default twice the ramp plus half a second.
fn brake_timeout(
    e: &mut Effective<'_>,
    cycle_time: Option<u32>,
    of: Option<&Velocities>,
    deceleration: Option<f64>,
) -> Option<u64> {
    let timeout_key = key(Name::SpindleBrakeTimeout);
    let given = e.duration(timeout_key)?;
    let (of, deceleration) = (of?, deceleration?);
    let ramp = ramp(f64::from(of.largest.value), f64::from(of.off.value), deceleration);
    let by_default = ramp.saturating_mul(2).saturating_add(BRAKE_RESERVE);
    if given > 0 && given < ramp {
        let found = format!(
            "{} is {}, and the ramp from vb_max {} (P-AXIS-00212) to {} (P-AXIS-00768) takes {}",
            e.title(timeout_key),
            time_text(given),
            of.largest.value,
            of.off.value,
            time_text(ramp)
        );
        let said = Diagnostic::error(codes::TOO_SHORT, e.place_of(timeout_key), found);
        let allowed = format!("{} <= brake_timeout, or 0s: twice the ramp and 0.5 s", time_text(ramp));
        e.report.push(said.allowed(allowed).instead(format!("spindle.brake_timeout = \"{}\"", time_text(by_default))));
    }
    let timeout = if given > 0 { given } else { by_default };
    if let Some(cycle) = cycle_time {
        countable(e, Name::SpindleBrakeTimeout, timeout, u64::from(cycle));
    }
    Some(timeout)
}

/// The time of the velocity command's ramp from one velocity down to another [ns].
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, and is not below 0")]
pub(super) fn ramp(from: f64, to: f64, deceleration: f64) -> u64 {
    // The product is exact: whole numbers up to 2^31, and the lowest nine binary digits of 1e9 are 0.
    ((from - to).larger(0.0) * 1e9 / deceleration).ceil() as u64
}

/// Checks that a time can be counted in cycles.
fn countable(e: &mut Effective<'_>, name: Name, timeout: u64, cycle: u64) {
    let longest = MOST_CYCLES * cycle;
    if timeout <= longest {
        return;
    }
    let at = key(name);
    let how = if e.given(at).is_some() { "is" } else { "has its default," };
    let time = match timeout {
        // The ramp saturates.
        u64::MAX => "more than 500 years".to_owned(),
        _ => format!("{}, {} cycles", time_text(timeout), timeout.div_ceil(cycle)),
    };
    let found = format!("{} {how} {time}", e.title(at));
    // The default of the brake timeout follows from the deceleration.
    let is_given = e.given(at).is_some() || name != Name::SpindleBrakeTimeout;
    let place = e.place_of(if is_given { at } else { key(Name::SpindleDeceleration) });
    let said = Diagnostic::error(codes::TOO_LONG, place, found);
    let allowed = format!("{MOST_CYCLES} cycles: {} at a cycle time of {}", time_text(longest), time_text(cycle));
    let instead = if name == Name::SpindleBrakeTimeout {
        "a shorter time, or a larger spindle.deceleration: 6000 is 1 rpm/s"
    } else {
        "a shorter time"
    };
    e.report.push(said.allowed(allowed).instead(instead));
}
