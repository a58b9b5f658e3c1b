//! Frequency and damping of a vibration from its decay after ramps. No spectrum: windows of ramps shift it.

use crate::least_squares::{Fit, fit};
use crate::segments::{Segment, after_ramps};
use crate::whole;
use portable::Extreme;
use std::f64::consts::TAU;
use std::ops::Range;

/// The time from a ramp's end to its window, and the length of a window [s].
const SETTLE: f64 = 0.15;
const LENGTH: f64 = 0.8;
/// How much later the windows of the second fit begin [s].
const LATER: f64 = 0.1;
/// Start values of the search: parts of the frequency, and dampings.
const PARTS: [f64; 5] = [0.94, 0.97, 1.0, 1.03, 1.06];
const DAMPINGS: [f64; 5] = [0.003, 0.01, 0.03, 0.08, 0.2];
/// Maximum number of Levenberg-Marquardt steps.
const STEPS: u32 = 40;
/// Step of the difference quotients of ln f and ln sigma.
const STEP: f64 = 1e-5;
/// A smaller step ends the search.
const PRECISION: f64 = 1e-9;
/// Weight of the diagonal, at the start and at the end.
const DAMPED: f64 = 1e-3;
const MOST_DAMPED: f64 = 1e9;

/// A vibration that decays. Noise disturbs a fit, and so do other vibrations that decay in the same window. A standard error
/// contains the difference to a fit whose windows begin 0.1 s later, when less of them is left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decay {
    /// [Hz], and its standard error
    pub hz: f64,
    pub hz_error: f64,
    /// zeta = sigma/|sigma + j 2 pi f|, and its standard error
    pub damping: f64,
    pub damping_error: f64,
    /// the largest amplitude at the beginning of a window, in the unit of the signal
    pub amplitude: f64,
}

impl Decay {
    /// This fit, with standard errors that contain the difference to another fit of the same vibration.
    pub(crate) fn compared_with(self, other: &Self) -> Self {
        Self {
            hz_error: libm::hypot(self.hz_error, self.hz - other.hz),
            damping_error: libm::hypot(self.damping_error, self.damping - other.damping),
            ..self
        }
    }
}

/// The other signals in a window.
#[derive(Clone, Copy, Debug, Default)]
pub struct Companions<'a> {
    /// for a following error: the gain of the position controller Kv [1/s], exp(-Kv t)
    pub position_gain: Option<f64>,
    /// frequencies of forced lines [Hz]
    pub forced: &'a [f64],
}

/// The windows after ramps in which vibrations decay: 0.8 s from 0.15 s after each ramp's end.
#[must_use]
pub fn windows(segments: &[Segment], cycle_time: f64) -> Vec<Range<usize>> {
    after_ramps(segments, whole(SETTLE / cycle_time), whole(LENGTH / cycle_time)).collect()
}

/// The vibration near a frequency [Hz] in windows of a signal: common f and sigma of exp(-sigma t) (cos, sin)(2 pi f t),
/// together with 1, t, t^2 and the companions in each window; variable projection (Golub, Pereyra 1973) on the scaled
/// signal. `None` if no decay is found there.
#[must_use]
pub fn decay(
    signal: &[f64],
    windows: &[Range<usize>],
    cycle_time: f64,
    near: f64,
    companions: Companions<'_>,
) -> Option<Decay> {
    let parts: Option<Vec<&[f64]>> = windows.iter().map(|window| signal.get(window.clone())).collect();
    let parts = parts.filter(|parts| !parts.is_empty())?;
    let (squares, samples) =
        parts.iter().flat_map(|part| part.iter()).fold((0.0, 0.0), |(sum, n), v| (sum + v * v, n + 1.0));
    let scale = (squares / samples).sqrt();
    let scaled: Vec<Vec<f64>> = parts.iter().map(|part| part.iter().map(|v| v / scale).collect()).collect();
    (scale > 0.0).then_some(())?;
    let problem = Problem { windows: scaled.iter().map(Vec::as_slice).collect(), cycle_time, companions };
    let starts =
        PARTS.iter().flat_map(|part| DAMPINGS.map(|damping| [libm::log(near * part), libm::log(TAU * near * damping)]));
    let mut best: Option<([f64; 2], f64)> = None;
    for start in starts {
        if let Some(cost) = problem.residual(start).map(|residual| squared(&residual))
            && best.is_none_or(|(_, least)| cost < least)
        {
            best = Some((start, cost));
        }
    }
    let place = problem.descend(best?.0)?;
    let found = problem.result(place, scale)?;
    let late = whole(LATER / cycle_time);
    let windows = scaled.iter().map(|window| window.get(late..)).collect::<Option<_>>()?;
    let later = Problem { windows, cycle_time, companions };
    let later = later.result(later.descend(place)?, scale)?;
    Some(found.compared_with(&later))
}

struct Problem<'a> {
    windows: Vec<&'a [f64]>,
    cycle_time: f64,
    companions: Companions<'a>,
}

fn squared(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum()
}

impl Problem<'_> {
    /// The fit of a window with these ln f, ln sigma: its first two columns are the vibration.
    fn fit(&self, window: &[f64], [ln_f, ln_sigma]: [f64; 2]) -> Option<Fit> {
        let (omega, sigma) = (TAU * libm::exp(ln_f), libm::exp(ln_sigma));
        let end = window.len() as f64 * self.cycle_time;
        let column = |of: &dyn Fn(f64) -> f64| (0..window.len()).map(|n| of(n as f64 * self.cycle_time)).collect();
        let mut columns: Vec<Vec<f64>> = vec![
            column(&|t| libm::exp(-sigma * t) * libm::cos(omega * t)),
            column(&|t| libm::exp(-sigma * t) * libm::sin(omega * t)),
            column(&|_| 1.0),
            column(&|t| t / end),
            column(&|t| t / end * (t / end)),
        ];
        columns.extend(self.companions.position_gain.map(|gain| column(&|t| libm::exp(-gain * t))));
        for hz in self.companions.forced {
            columns.extend([column(&|t| libm::cos(TAU * hz * t)), column(&|t| libm::sin(TAU * hz * t))]);
        }
        fit(&columns, window)
    }

    fn residual(&self, place: [f64; 2]) -> Option<Vec<f64>> {
        let mut residual = Vec::new();
        for window in &self.windows {
            residual.extend(self.fit(window, place)?.residual);
        }
        Some(residual)
    }

    /// The residual, and its derivatives with respect to ln f and ln sigma.
    fn linear(&self, place: [f64; 2]) -> Option<(Vec<f64>, [Vec<f64>; 2])> {
        let by = |i: usize| {
            let at = |step: f64| self.residual(std::array::from_fn(|k| place[k] + if k == i { step } else { 0.0 }));
            let (above, below) = (at(STEP)?, at(-STEP)?);
            Some(above.iter().zip(&below).map(|(a, b)| (a - b) / (2.0 * STEP)).collect::<Vec<_>>())
        };
        Some((self.residual(place)?, [by(0)?, by(1)?]))
    }

    /// Levenberg-Marquardt search from a place; `None` if it leaves the range of decaying vibrations.
    fn descend(&self, mut place: [f64; 2]) -> Option<[f64; 2]> {
        let mut damped = DAMPED;
        for _ in 0..STEPS {
            let (residual, jacobian) = self.linear(place)?;
            let cost = squared(&residual);
            let (normal, gradient) = normal(&jacobian, &residual);
            let mut moved = None;
            while damped < MOST_DAMPED && moved.is_none() {
                let [a, b, c] = [normal[0] * (1.0 + damped), normal[1], normal[2] * (1.0 + damped)];
                let determinant = a * c - b * b;
                let step = [
                    (b * gradient[1] - c * gradient[0]) / determinant,
                    (b * gradient[0] - a * gradient[1]) / determinant,
                ];
                let next = [place[0] + step[0], place[1] + step[1]];
                if self.residual(next).is_some_and(|residual| squared(&residual) <= cost) {
                    moved = Some((next, libm::fabs(step[0]) + libm::fabs(step[1])));
                    damped *= 0.1;
                } else {
                    damped *= 10.0;
                }
            }
            let Some((next, step)) = moved else { break };
            place = next;
            if step < PRECISION {
                break;
            }
        }
        Some(place)
    }

    fn result(&self, place: [f64; 2], scale: f64) -> Option<Decay> {
        let (residual, jacobian) = self.linear(place)?;
        let mut amplitude = 0.0;
        let mut columns = 2;
        for window in &self.windows {
            let fit = self.fit(window, place)?;
            columns += fit.coefficients.len();
            let [cos, sin] = [fit.coefficients[0], fit.coefficients[1]];
            amplitude = (cos * cos + sin * sin).sqrt().larger(amplitude);
        }
        let free = residual.len().checked_sub(columns).filter(|free| *free > 0)? as f64;
        let ([a, b, c], _) = normal(&jacobian, &residual);
        let variance = squared(&residual) / free / (a * c - b * b);
        let [of_f, of_sigma, common] = [c * variance, a * variance, -b * variance];
        let [hz, sigma] = place.map(libm::exp);
        let omega = TAU * hz;
        let damping = sigma / (sigma * sigma + omega * omega).sqrt();
        let of_damping = damping * (1.0 - damping * damping);
        let decay = Decay {
            hz,
            hz_error: hz * of_f.sqrt(),
            damping,
            damping_error: of_damping * (of_f + of_sigma - 2.0 * common).larger(0.0).sqrt(),
            amplitude: amplitude * scale,
        };
        (decay.hz_error.is_finite() && decay.damping_error.is_finite()).then_some(decay)
    }
}

/// J' J as its three numbers, and J' r.
fn normal([f, sigma]: &[Vec<f64>; 2], residual: &[f64]) -> ([f64; 3], [f64; 2]) {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    ([dot(f, f), dot(f, sigma), dot(sigma, sigma)], [dot(f, residual), dot(sigma, residual)])
}
