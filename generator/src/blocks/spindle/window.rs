//! The window around the velocity of position control: wide enough for the steps of the encoder, narrow enough that position
//! control does not begin at another speed.

use super::limits::{rpm, window};
use super::velocities::{Velocities, asks};
use crate::config::values::key;
use crate::parameters::{Name, time_text};
use crate::rules::{drive, effective::Effective};
use crate::{codes, design::scale, diagnostics::Diagnostic, number::rounded};
use portable::Extreme;

/// 1 rpm, the window of a standstill: the default of `spindle.window` [0.001 deg/s].
const STANDSTILL: f64 = 6000.0;

/// The steps of an actual velocity that comes from an encoder.
#[derive(Clone, Copy, Debug)]
struct Steps {
    /// twice the velocity of one increment per cycle [0.001 deg/s]
    two: f64,
    cycle_ns: u32,
}

/// The steps of the encoder; `None` if the list states no path resolution.
fn steps(e: &mut Effective<'_>, cycle_ns: u32, gear: u32) -> Option<Steps> {
    let [num, denom] = [Name::WegaufZ, Name::WegaufN].map(|name| (name, [gear, 0]));
    if e.given(num).is_none() || e.given(denom).is_none() {
        return None;
    }
    let resolution = scale::resolution(&drive::resolution(e, gear)?);
    // In increments per 0.0001 deg.
    let step = 0.1 / resolution * 1e9 / f64::from(cycle_ns);
    // The quotient is rounded, so that it is a number that a list can contain.
    (resolution > 0.0).then_some(Steps { two: (2.0 * step * 1e3).round() / 1e3, cycle_ns })
}

/// The least width of the window: the given one, or the default, which follows from the encoder's steps.
pub(super) fn settled(e: &mut Effective<'_>, cycle_ns: Option<u32>, gear: u32, of: Option<&Velocities>) -> Option<f64> {
    let at = key(Name::SpindleWindow);
    let mut least = e.real(at)?;
    let steps = cycle_ns.and_then(|ns| steps(e, ns, gear));
    let is_given = e.given(at).is_some();
    let off = of.map_or(0, |of| of.off.value);
    match steps {
        Some(Steps { two, .. }) if !is_given => least = least.larger(two),
        Some(Steps { two, .. }) if window(off, least) < two => {
            let steps = format!("two steps of the encoder are {} rpm", rpm(two));
            narrow(e, least, window(off, least), &steps, two);
        }
        _ if is_given && least < window(off, least) => {
            narrow(e, least, least, &format!("1 % of Voff holds, {} rpm", rpm(window(off, least))), window(off, least));
        }
        _ => {}
    }
    // Another rule reports velocities in the wrong order. A drive with velocity control alone never begins position control.
    if let Some(of) = of.filter(|of| of.on.value >= of.off.value) {
        wide(e, of, window(off, least), steps);
    }
    Some(least)
}

/// Warns of a written window below another width, in the words of `other`.
fn narrow(e: &mut Effective<'_>, least: f64, holds: f64, other: &str, width: f64) {
    let at = key(Name::SpindleWindow);
    let found = format!("{} is {}, {} rpm: {other}", e.title(at), rounded(least), rpm(holds));
    let instead = format!("spindle.window = {}, or without it", width.ceil());
    e.warn(codes::NARROW_WINDOW, at, found, instead);
}

/// Checks the speed at which position control may begin, Voff + window: not above Von, at which it ends, and not a multiple of
/// Voff.
fn wide(e: &mut Effective<'_>, of: &Velocities, window: f64, steps: Option<Steps>) {
    let [on, off] = [of.on, of.off].map(|of| f64::from(of.value));
    // A window within which equal velocities differ is one of measurement.
    let largest = (on - off).larger(STANDSTILL).larger(off / 100.0);
    let is_beyond = on > 0.0 && window > largest;
    if !is_beyond && window <= off.larger(STANDSTILL) {
        return;
    }
    let at = key(Name::SpindleWindow);
    let is_given = e.given(at).is_some();
    let begins = rpm(off + window);
    let why = match steps.filter(|_| !is_given) {
        Some(steps) => {
            let cycle = time_text(u64::from(steps.cycle_ns));
            format!("the window is {} rpm, two steps of the encoder in a cycle of {cycle}", rpm(window))
        }
        None => format!("{} is {}, {} rpm", e.title(at), rounded(window), rpm(window)),
    };
    let found = format!("{why}: position control can begin at up to {begins} rpm");
    let voff = format!("{} is {}, {} rpm", e.title(of.off.key), of.off.value, rpm(off));
    let place = if is_given { e.place_of(at) } else { e.place_near(of.off.key, asks) };
    let (said, largest, other) = if is_beyond {
        let found =
            format!("{found}, and it ends at {} rpm: {voff}, {} is {}", rpm(on), e.title(of.on.key), of.on.value);
        let allowed = "a window of at most Von - Voff (P-AXIS-00767, 00768); 1 rpm and 1 % of Voff are always allowed";
        let other = format!("v_velocity_control_on {} or more", (off + window).ceil());
        (Diagnostic::error(codes::WINDOW_BEYOND, place, found).allowed(allowed), largest, other)
    } else {
        let how = if off > 0.0 { ", more than twice Voff" } else { "" };
        let said = Diagnostic::warning(codes::WIDE_WINDOW, place, format!("{found}{how}: {voff}"));
        (said, off.larger(STANDSTILL), format!("v_position_control_on {} or more", window.ceil()))
    };
    e.report.push(said.instead(instead(is_given, largest, other, steps)));
}

/// What to write instead: the largest window, if it was written and the encoder allows that; else what its default follows from.
fn instead(is_given: bool, largest: f64, other: String, steps: Option<Steps>) -> String {
    if is_given && steps.is_none_or(|steps| steps.two <= largest) {
        return format!("spindle.window = {largest}, or {other}");
    }
    format!("{other}, a longer cycle, or an encoder with more increments per revolution (P-AXIS-00234/00233)")
}
