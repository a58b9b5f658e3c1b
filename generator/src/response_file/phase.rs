//! The dead time of a response: what its phase falls beyond the minimum phase of its magnitude. It shows a phase in another unit, with the other sign,
//! and a signal that was recorded elsewhere.
//!
//! ```text
//! ln|P| on 512 frequencies up to half the sampling frequency; held below the lines, above them it falls by half of their slope
//! c_n = its cosine series; minimum phase = -2 sum c_n sin(n w)
//! dead time = the tau that maximises sum q Re(exp(j (phase - minimum phase + w tau))), q = 1/(0.05^2 + relative error^2)
//! ```
//! What |P| does above the last line is not known. Falling faster there would count less as dead time, a sampled system falls more slowly: on these
//! the dead time is known to 0.2 cycles from lines up to a fifth of half the sampling frequency on. A response that was measured in the drive
//! gets up to 0.4 cycles more than it has with lines up to a quarter of the sampling frequency, and up to 1.2 with lines up to a tenth: too much
//! rather than too little.

use super::{From, Point, Said, magnitude, turned};
use crate::codes;
use crate::number::decimals;
use portable::Extreme;
use stability::Complex64;
use std::f64::consts::{PI, TAU};

/// Frequencies from 0 to half the sampling frequency.
const HALF: usize = 512;
/// Lines that reach less far, in cycles, show no dead time.
const LEAST_REACH: f64 = 0.05;
/// Dead times that are tried [cycles].
const FROM: f64 = -8.0;
const STEP: f64 = 0.05;
const STEPS: u16 = 640;
/// So far the lines agree with a dead time, 1: entirely.
const AGREES: f64 = 0.7;
/// So far a dead time is known [cycles].
const TOLERANCE: f64 = 0.2;
/// The error of a line that counts as exact.
const EXACT: f64 = 0.05;
/// More lines do not make the dead time better known.
const MOST_LINES: usize = 400;

/// What the dead time of phases needs.
pub(super) struct Dead {
    /// w T, minimum phase, weight; none: the lines do not reach far enough
    lines: Vec<[f64; 3]>,
    /// only every n-th of the lines that were given
    every: usize,
    /// 1/T
    rate: f64,
}

/// A dead time [cycles], and how far the lines agree with it.
#[derive(Clone, Copy, Debug)]
struct Found {
    cycles: f64,
    agreement: f64,
}

impl Dead {
    /// Of frequencies [Hz] and magnitudes with their relative errors. An open speed plant integrates: its magnitude is multiplied by |1 - z^-1|.
    pub(super) fn new(lines: impl Iterator<Item = (f64, f64)>, errors: &[f64], from: From, cycle_time: f64) -> Self {
        let integrates = matches!(from, From::Current { .. });
        let rate = 1.0 / cycle_time;
        let lines: Vec<[f64; 2]> = lines
            .map(|(hz, size)| {
                let w = TAU * hz * cycle_time;
                let difference = if integrates { 2.0 * libm::sin(0.5 * w) } else { 1.0 };
                [w, libm::log(size * difference)]
            })
            .collect();
        let every = lines.len().div_ceil(MOST_LINES).max(1);
        if lines.last().is_none_or(|[w, _]| *w < TAU * LEAST_REACH) {
            return Self { lines: Vec::new(), every, rate };
        }
        let series = cosine_series(&lines);
        let lines = lines.iter().zip(errors).step_by(every).map(|([w, _], error)| {
            let differentiated = if integrates { 0.5 * (PI - w) } else { 0.0 };
            [*w, minimum_phase(&series, *w) - differentiated, 1.0 / (EXACT * EXACT + error * error)]
        });
        Self { lines: lines.collect(), every, rate }
    }

    pub(super) fn is_known(&self) -> bool {
        !self.lines.is_empty()
    }

    /// Of these phases [rad], one a line.
    fn of(&self, phases: &[f64]) -> Found {
        let mut turning: Vec<[Complex64; 2]> = self
            .lines
            .iter()
            .zip(phases.iter().step_by(self.every))
            .map(|([w, minimum, weight], phase)| [turned(phase - minimum + w * FROM) * *weight, turned(w * STEP)])
            .collect();
        let all: f64 = self.lines.iter().map(|[_, _, weight]| weight).sum();
        let mut best = Found { cycles: FROM, agreement: f64::NEG_INFINITY };
        for step in 0..=STEPS {
            let agreement = turning.iter().map(|[value, _]| value.re).sum::<f64>() / all;
            if agreement > best.agreement {
                best = Found { cycles: FROM + f64::from(step) * STEP, agreement };
            }
            turning.iter_mut().for_each(|[value, by]| *value *= *by);
        }
        best
    }

    /// What the phases give, for a message.
    pub(super) fn words(&self, phases: &[f64]) -> String {
        let found = self.of(phases);
        if found.agreement >= AGREES {
            format!("a dead time of {} cycles", cycles(found.cycles))
        } else {
            "no dead time".to_owned()
        }
    }

    /// Whether the phases give a dead time that can be: one cycle at least from the CNC to the motor and back, what the measurement
    /// does not contain among it, and none below 0 within the drive.
    pub(super) fn fits(&self, phases: &[f64], from: From) -> bool {
        let least = match from {
            From::Command { delay } => (1.0 - delay * self.rate).larger(0.0),
            From::Current { .. } => 0.0,
        };
        let found = self.of(phases);
        self.is_known() && found.agreement >= AGREES && found.cycles >= least - TOLERANCE
    }
}

/// The dead time [s] from the commanded velocity to the motor's. Below one cycle it is a mistake: the effect of a command
/// is read in the next cycle at the earliest.
pub(super) fn dead_time(
    points: &[Point],
    place: [usize; 2],
    from: From,
    cycle_time: f64,
    said: &mut Said<'_>,
) -> Option<f64> {
    let errors: Vec<f64> = points.iter().map(|point| point.error).collect();
    let lines = points.iter().map(|point| (point.hz, magnitude(point.response)));
    // The response is closed by now, whatever it was measured from.
    let dead = Dead::new(lines, &errors, From::Command { delay: 0.0 }, cycle_time);
    let phases: Vec<f64> = points.iter().map(|point| libm::atan2(point.response.im, point.response.re)).collect();
    let found = dead.is_known().then(|| dead.of(&phases)).filter(|found| found.agreement >= AGREES)?;
    if found.cycles < 1.0 - TOLERANCE {
        let missing = (1.0 - found.cycles) * cycle_time;
        let with = match from {
            From::Command { delay } | From::Current { delay, .. } if delay > 0.0 => " with the delay that was added",
            _ => "",
        };
        let text =
            format!("a dead time of {} cycles{with}: the motor would answer before it is read", cycles(found.cycles));
        said.push(
            said.error(codes::DEAD_TIME, place, text)
                .allowed("1 cycle or more, from the cycle that writes the commanded velocity to the cycle that reads its effect")
                .instead(format!(
                    "a response recorded by the task that runs the block; if it was measured in the drive, the cycles between CNC and drive \
                     as its delay, at least {} ms more",
                    decimals(1e3 * missing, 2)
                )),
        );
    }
    Some(found.cycles * cycle_time)
}

fn cycles(value: f64) -> String {
    decimals(value, 2)
}

/// c_n of ln|P| over w, n = 0..HALF, through straight lines between the lines and held beyond them.
fn cosine_series(lines: &[[f64; 2]]) -> Vec<f64> {
    let all = 2 * HALF;
    let step = PI / to_real(HALF);
    let cosine: Vec<f64> = (0..all).map(|index| libm::cos(step * to_real(index))).collect();
    let tail = tail(lines);
    let values: Vec<f64> = (0..=HALF).map(|index| between(lines, step * to_real(index), tail)).collect();
    let series = (0..HALF).map(|n| {
        let inner: f64 = (1..HALF).map(|k| values[k] * cosine[(k * n) % all]).sum();
        let ends = values[0] + values[HALF] * cosine[(HALF * n) % all];
        (ends + 2.0 * inner) / to_real(all)
    });
    series.collect()
}

/// Half of the slope of ln|P| over ln w in the last octave, where it falls, but by no more than 20 dB a decade.
fn tail(lines: &[[f64; 2]]) -> f64 {
    let Some([last, top]) = lines.last() else { return 0.0 };
    let octave = lines.iter().find(|[w, _]| *w >= 0.5 * last);
    let slope = octave.filter(|[w, _]| w < last).map_or(0.0, |[w, value]| (top - value) / libm::log(last / w));
    0.5 * slope.clamp(-2.0, 0.0)
}

fn between(lines: &[[f64; 2]], w: f64, tail: f64) -> f64 {
    let above = lines.partition_point(|[line, _]| *line <= w);
    match (above.checked_sub(1).map(|below| lines[below]), lines.get(above).copied()) {
        (Some([from, a]), Some([to, b])) => a + (b - a) * (w - from) / (to - from),
        (Some([from, a]), None) => a + tail * libm::log(w / from),
        (None, Some([_, held])) => held,
        (None, None) => 0.0,
    }
}

/// -2 sum c_n sin(n w), by Clenshaw's recurrence.
fn minimum_phase(series: &[f64], w: f64) -> f64 {
    let (sin, cos) = libm::sincos(w);
    let (mut one, mut two) = (0.0, 0.0);
    for value in series[1..].iter().rev() {
        (one, two) = (value + 2.0 * cos * one - two, one);
    }
    -2.0 * one * sin
}

#[expect(clippy::cast_precision_loss, reason = "an index of a grid")]
fn to_real(index: usize) -> f64 {
    index as f64
}
