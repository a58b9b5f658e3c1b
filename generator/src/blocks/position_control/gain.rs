//! The largest gain of a position loop in the CNC. The delay limits it, however fast the drive is.
//!
//! ```text
//! L = Kv T z^-1/(1 - z^-1) z^-d (1 - e)/(1 - e z^-1),   z^-1 = exp(-j w), e = exp(-T / time constant)
//! |L| = Kv T (1 - e) / (2 sin(w/2) |1 - e z^-1|)
//! arg L = -90 deg - (d + 1/2) w - atan2(e sin w, 1 - e cos w)
//! ```
//! d is the delay in cycles from the velocity command to the actual velocity that it causes, one for an ideal drive. The loop
//! is stable up to the gain for which |L| = 1 at the w where it has lost 90 deg more than the integrator: with one cycle
//! Kv T = 1. Up to the gain for which it has lost 30 deg more it keeps a phase margin of 60 deg, with which a command is
//! followed nearly without overshoot: Kv T = 2 sin(10 deg) = 0.347.

use crate::codes;
use crate::config::values::Key;
use crate::number::rounded;
use crate::parameters::{Name, time_text};
use crate::rules::drive::{given_number, stated_delay};
use crate::rules::effective::Effective;
use std::f64::consts::PI;

/// What the loop may lose more than the 90 deg of its integrator, to be stable and for a phase margin of 60 deg [rad].
const STABLE: f64 = PI / 2.0;
const CALM: f64 = PI / 6.0;
/// Each halving of the interval of w gives a binary digit.
const DIGITS: u32 = 60;

/// The delay of a drive.
#[derive(Clone, Copy, Debug)]
struct Lag {
    /// d
    cycles: f64,
    /// e
    rest: f64,
}

impl Lag {
    /// Kv T for which the loop has lost this angle more than its integrator where |L| is 1.
    fn gain(self, angle: f64) -> f64 {
        let Self { cycles, rest } = self;
        let remaining = |w: f64| [1.0 - rest * libm::cos(w), rest * libm::sin(w)];
        let lost = |w: f64| {
            let [re, im] = remaining(w);
            (cycles + 0.5) * w + libm::atan2(im, re)
        };
        // It rises with w: its slope is above d.
        let [mut w, mut beyond] = [0.0, PI];
        for _ in 0..DIGITS {
            let middle = (w + beyond) / 2.0;
            if lost(middle) < angle { w = middle } else { beyond = middle }
        }
        let [re, im] = remaining(w);
        2.0 * libm::sin(w / 2.0) * libm::hypot(re, im) / (1.0 - rest)
    }
}

/// Checks Kv of a position loop in the CNC.
pub(super) fn check(e: &mut Effective<'_>, cycle_ns: u32, kv_key: Key, kv: u32) {
    let (lag, whose) = lag(e, cycle_ns);
    // In 0.01/s, and rounded: one cycle of 1 ms is 100000.
    let limit = |angle: f64| rounded(lag.gain(angle) * 1e11 / f64::from(cycle_ns));
    let [stable, calm] = [STABLE, CALM].map(limit);
    let kv = f64::from(kv);
    if kv <= calm {
        return;
    }
    let found = format!("{} is {kv}, {}/s, at a cycle time of", e.title(kv_key), rounded(kv / 100.0));
    let found = format!("{found} {} and with {whose}", time_text(u64::from(cycle_ns)));
    let calm = calm.floor();
    if kv >= stable {
        let found = format!("{found}: the position loop in the CNC is unstable");
        let allowed = format!("kv below {stable} [0.01/s]");
        let instead = format!(
            "getriebe[{}].kv with the gain of the machine; up to {calm} the phase margin is 60 deg",
            kv_key.1[0]
        );
        e.refuse(codes::KV_UNSTABLE, kv_key, found, [Some(allowed), Some(instead)]);
    } else {
        let part = rounded(kv / stable * 100.0);
        let found = format!("{found}: {part} % of the gain from which the position loop in the CNC is unstable");
        let instead = format!("getriebe[{}].kv {calm} or less, up to which the phase margin is 60 deg", kv_key.1[0]);
        e.warn(codes::KV_NEAR, kv_key, found, instead);
    }
}

/// The lag of the drive that the axis states, else that of an ideal drive, and whose it is. Where a value is out of range,
/// its own rule says so.
fn lag(e: &Effective<'_>, cycle_ns: u32) -> (Lag, String) {
    let (cycles, whose) = match stated_delay(e) {
        Some((cycles, whose)) => {
            let plural = if cycles > 1.0 { "s" } else { "" };
            (cycles, format!("a delay of {cycles} cycle{plural} ({whose})"))
        }
        None => (1.0, "the delay of an ideal drive, one cycle".to_owned()),
    };
    match given_number(e, Name::DriveTimeConstant).filter(|ns| *ns > 0.0) {
        Some(ns) => {
            let whose = format!("{whose} and a time constant of {} ms (drive.time_constant)", rounded(ns / 1e6));
            (Lag { cycles, rest: libm::exp(-f64::from(cycle_ns) / ns) }, whose)
        }
        None => (Lag { cycles, rest: 0.0 }, whose),
    }
}
