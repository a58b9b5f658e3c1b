//! The position lag of a spindle: as an angle it must stay below half a revolution, or it is taken for one the other way.

use super::limits;
use super::limits::rpm;
use super::velocities::{Velocities, Velocity, asks};
use crate::config::values::Key;
use crate::rules::effective::Effective;
use crate::{codes, diagnostics::Diagnostic, number::rounded};
use portable::Extreme;

/// The lag at which the block opens its loop [0.001 deg].
const LARGEST: f64 = 170_000.0;

/// A quarter turn [0.001 deg]: with three missing samples the lag of a blocked spindle grows by four times the way of a cycle,
/// and the block knows it if that is less than a turn.
const SEEN: f64 = 90_000.0;

/// The gain of the position controller.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gain {
    pub(super) key: Key,
    /// [0.01/s]
    pub(super) kv: u32,
}

impl Gain {
    /// The lag at a velocity of which this part is not fed forward [0.001 deg].
    fn lag(self, velocity: f64, part: f64) -> f64 {
        part * velocity / (f64::from(self.kv) / 100.0)
    }

    /// The largest velocity whose lag is allowed [0.001 deg/s].
    fn largest_velocity(self, part: f64) -> f64 {
        (LARGEST * (f64::from(self.kv) / 100.0) / part).ceil() - 1.0
    }

    /// The smallest gain with which the lag is allowed, as text.
    fn smallest(self, velocity: f64, part: f64) -> String {
        let kv = (part * velocity / LARGEST * 100.0).floor() + 1.0;
        format!("getriebe[{}].kv {kv} or more", self.key.1[0])
    }
}

/// Checks that the lag of a loop in the CNC stays below half a revolution. `weight` is that of its feedforward, followed by
/// whether it is always active.
pub(super) fn in_cnc(e: &mut Effective<'_>, of: &Velocities, gain: Gain, (weight, is_always): (f64, bool)) {
    let slower = if of.on.value <= of.largest.value { of.on } else { of.largest };
    let velocity = f64::from(slower.value);
    let rest = (1.0 - weight).abs();
    let (code, part) = match () {
        () if gain.lag(velocity, rest) >= LARGEST => (codes::LOOP_LAG, rest),
        () if !is_always && gain.lag(velocity, 1.0) >= LARGEST => (codes::LAG_ALONE, 1.0),
        () => return,
    };
    let how = if code == codes::LAG_ALONE { ", without feedforward" } else { "" };
    let found = format!(
        "the position lag at {} rpm is {} deg{how}: {}",
        rpm(velocity),
        rounded(gain.lag(velocity, part) / 1000.0),
        reasons(e, slower, gain)
    );
    let place = e.place_near(if e.given(slower.key).is_some() { slower.key } else { gain.key }, asks);
    let said = match code {
        codes::LOOP_LAG => Diagnostic::error(code, place, found),
        _ => Diagnostic::warning(code, place, found),
    };
    // What is written instead holds without the feedforward too, if that can be inactive.
    let worst = if is_always { part } else { part.larger(1.0) };
    let (largest, smallest) = (gain.largest_velocity(worst), gain.smallest(velocity, worst));
    let lower = (largest >= f64::from(of.off.value)).then(|| format!("v_velocity_control_on {largest} or less, or "));
    let said = said.allowed("a lag below 170 deg: (1 - w) v / Kv");
    e.report.push(said.instead(lower.unwrap_or_default() + &smallest));
}

/// Warns of a velocity at which the lag of a blocked spindle grows from below the limit of the loop in the CNC to a harmless
/// angle within one cycle, so that the block does not notice it.
pub(super) fn seen(e: &mut Effective<'_>, of: &Velocities, cycle_ns: u32) {
    let slower = if of.on.value <= of.largest.value { of.on } else { of.largest };
    let way = f64::from(slower.value) * f64::from(cycle_ns) / 1e9;
    if way <= SEEN {
        return;
    }
    let found = format!(
        "{} is {}: until velocity control begins, M3 and M4 turn the spindle with up to {} rpm, {} deg in a cycle",
        e.title(slower.key),
        slower.value,
        rpm(f64::from(slower.value)),
        rounded(way / 1000.0)
    );
    let place = e.place_near(if e.given(slower.key).is_some() { slower.key } else { of.off.key }, asks);
    let largest = (SEEN * 1e9 / f64::from(cycle_ns)).floor();
    let said = Diagnostic::warning(codes::LAG_UNSEEN, place, found);
    e.report.push(said.instead(format!("v_velocity_control_on {largest} or less, or a shorter cycle")));
}

/// Checks the lag with which a drive takes up position control: the position command is an angle, which the drive takes the
/// shortest way. `part` of the velocity is not fed forward. A spindle that the block finds turning is taken up at up to Voff +
/// its window, which is at least `least`; a window beyond Von is refused elsewhere, and so is a Von below Voff, with which the
/// lag is that at Voff.
pub(super) fn in_drive(e: &mut Effective<'_>, of: &Velocities, least: f64, gain: Gain, part: f64) {
    let window = limits::window(of.off.value, least);
    let [on, off] = [of.on, of.off].map(|of| f64::from(of.value));
    let fastest = (off + window).smaller(on).larger(off);
    let (code, velocity) = match () {
        () if gain.lag(off, part) >= LARGEST => (codes::LOOP_LAG, off),
        () if gain.lag(fastest, part) >= LARGEST => (codes::LAG_TAKEN_UP, fastest),
        () => return,
    };
    let lag = rounded(gain.lag(velocity, part) / 1000.0);
    let reasons = reasons(e, of.off, gain);
    let [speed, window] = [velocity, window].map(rpm);
    let place = e.place_near(if e.given(of.off.key).is_some() { of.off.key } else { gain.key }, asks);
    let said = if code == codes::LOOP_LAG {
        let found = format!("the drive takes up position control at {speed} rpm with a lag of {lag} deg: {reasons}");
        Diagnostic::error(code, place, found)
    } else {
        let found = format!(
            "the drive can take up position control at up to {speed} rpm, with a lag of {lag} deg: {reasons}, and its window is \
             {window} rpm"
        );
        Diagnostic::warning(code, place, found)
    };
    // With its window it stays within the largest velocity.
    let largest = gain.largest_velocity(part);
    let lower = (largest - least).smaller(largest / 1.01).floor();
    let lower = if lower >= 0.0 {
        format!("v_position_control_on {lower} or less")
    } else {
        format!("v_position_control_on and its window {largest} or less together")
    };
    let instead = format!("{lower}, or {}", gain.smallest(fastest, part));
    let allowed = "a lag below 170 deg: (1 - w) v / Kv, which the drive takes the shortest way";
    e.report.push(said.allowed(allowed).instead(instead));
}

/// The velocity and the gain that make a lag.
fn reasons(e: &Effective<'_>, velocity: Velocity, gain: Gain) -> String {
    format!("{} is {}, {} is {}", e.title(velocity.key), velocity.value, e.title(gain.key), gain.kv)
}
