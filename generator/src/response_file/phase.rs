//! The dead time of a response: the part of its phase beyond the minimum phase of its magnitude. It reveals a phase in
//! another unit or with the other sign, and a signal that was recorded elsewhere.
//!
//! ```text
//! ln|P| on 512 frequencies up to half the sampling frequency; held below the lines, above them it falls by half of their slope
//! c_n = its cosine series; minimum phase = -2 sum c_n sin(n w)
//! dead time = the tau that maximises sum q Re(exp(j (phase - minimum phase + w tau))), q = 1/(0.05^2 + relative error^2)
//! ```
//! |P| above the last line is unknown. If it falls faster there than assumed, the real dead time is smaller; a sampled
//! system falls more slowly. For sampled systems the error is at most 0.2 cycles with lines up to at least a fifth of half
//! the sampling frequency. A response that was measured in the drive gets up to 0.4 cycles too much with lines up to a
//! quarter of the sampling frequency, and up to 1.2 cycles too much with lines up to a tenth: too much rather than too
//! little.

use super::{From, Point, Said, magnitude, turned};
use crate::codes;
use crate::number::decimals;
use portable::Extreme;
use stability::Complex64;
use std::f64::consts::{PI, TAU};

/// Frequencies from 0 to half the sampling frequency.
const HALF: usize = 512;
/// Lines must reach this frequency, in cycles, to show a dead time.
const LEAST_REACH: f64 = 0.05;
/// Range of dead times that are tried [cycles].
const FROM: f64 = -8.0;
const STEP: f64 = 0.05;
const STEPS: u16 = 640;
/// Agreement of the lines with a dead time from which it counts; 1 is complete agreement.
const AGREES: f64 = 0.7;
/// Uncertainty of a dead time [cycles].
const TOLERANCE: f64 = 0.2;
/// The error of a line that counts as exact.
const EXACT: f64 = 0.05;
/// More lines do not improve the dead time.
const MOST_LINES: usize = 400;

/// Data for finding the dead time of phases.
pub(super) struct Dead {
    /// w T, minimum phase, weight; empty if the lines do not reach far enough
    lines: Vec<[f64; 3]>,
    /// only every n-th of the given lines is used
    every: usize,
    /// 1/T
    rate: f64,
}

/// A dead time [cycles], and the agreement of the lines with it.
#[derive(Clone, Copy, Debug)]
struct Found {
    cycles: f64,
    agreement: f64,
}

impl Dead {
    /// From frequencies [Hz] and magnitudes with their relative errors. An open speed plant integrates: its magnitude is
    /// multiplied by |1 - z^-1|.
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

    /// The dead time of these phases [rad], one per line.
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

    /// The dead time of the phases, for a message.
    pub(super) fn words(&self, phases: &[f64]) -> String {
        let found = self.of(phases);
        if found.agreement >= AGREES {
            format!("a dead time of {} cycles", cycles(found.cycles))
        } else {
            "no dead time".to_owned()
        }
    }

    /// Whether the dead time of the phases is possible: at least one cycle from the CNC to the motor and back, including the
    /// part that the measurement does not contain, and not below 0 within the drive.
    pub(super) fn fits(&self, phases: &[f64], from: From) -> bool {
        let least = match from {
            From::Command { delay } => (1.0 - delay * self.rate).larger(0.0),
            From::Current { .. } => 0.0,
        };
        let found = self.of(phases);
        self.is_known() && found.agreement >= AGREES && found.cycles >= least - TOLERANCE
    }
}

/// The dead time [s] from the commanded velocity to the motor's. Below one cycle it is an error: the effect of a command is
/// read in the next cycle at the earliest.
pub(super) fn dead_time(
    points: &[Point],
    place: [usize; 2],
    from: From,
    cycle_time: f64,
    said: &mut Said<'_>,
) -> Option<f64> {
    let errors: Vec<f64> = points.iter().map(|point| point.error).collect();
    let lines = points.iter().map(|point| (point.hz, magnitude(point.response)));
    // The response is that of the closed loop here, for any input of the measurement.
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

/// c_n of ln|P| over w, n = 0..HALF, with straight lines between the measured ones, constant beyond them.
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

/// Half of the slope of ln|P| over ln w in the last octave, if it falls, limited to 20 dB per decade.
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
