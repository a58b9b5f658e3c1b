//! The delay of one channel of a recording relative to another one that it follows in a known way. Not the dead time of an
//! axis: an offset between `v_cmd` and `v_motor` cannot be determined, because one more cycle of delay gives a bit-identical
//! record.

use crate::welch::Spectra;
use crate::{Complex64, angle, magnitude, turned};
use portable::Extreme;
use std::f64::consts::TAU;

/// Samples of a segment of the spectra.
const SEGMENT: usize = 2048;
/// Lines with less coherence are left out; the minimum number of remaining lines.
const LEAST_COHERENCE: f64 = 0.3;
const FEWEST_LINES: usize = 8;
/// Upper limit of a coherence, so that q stays finite.
const LARGEST_COHERENCE: f64 = 1.0 - 1e-9;
/// Range of the search for an offset [s], and its steps.
const LARGEST: f64 = 10e-3;
const STEP: f64 = 0.05e-3;
/// An offset with a larger error is unknown [s].
const LARGEST_ERROR: f64 = 0.1e-3;
/// An offset is also unknown if another one is almost as good.
const AS_GOOD: f64 = 0.9;
/// Number of Gauss-Newton steps.
const REFINEMENTS: u32 = 8;

/// A time with its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// [s]
    pub seconds: f64,
    /// [s]
    pub error: f64,
}

/// The delay of `y` relative to `x` [s], where y = F x with a known response F: 1 for the same velocity twice, j 2 pi f for
/// a velocity and its position, C for `v_motor` and the `v_add` of a dry run.
///
/// ```text
/// G = S_xy / (S_xx F)      Welch, segments of 2048 samples, lines with a coherence k above 0.3, at least 8
/// tau: largest sum of q Re(G/|G| exp(j w tau)), q = k/(1 - k), within +-10 ms
/// error: (sum of q w^2)^-1/2, times the rms of the weighted residual phases if it is above 1
/// ```
///
/// `None` if unknown: the record does not determine it to 0.1 ms, or two values are almost equally good.
#[must_use]
pub fn between(x: &[f64], y: &[f64], cycle_time: f64, known: impl Fn(f64) -> Complex64) -> Option<Time> {
    let spectra = Spectra::of(x, y, SEGMENT)?;
    let phasor = |k: usize| {
        let coherence = spectra.coherence(k).smaller(LARGEST_COHERENCE);
        let hz = k as f64 / (spectra.length as f64 * cycle_time);
        let unit = spectra.xy[k] / known(hz);
        let unit = unit / magnitude(unit);
        let is_known = coherence > LEAST_COHERENCE && unit.re.is_finite() && unit.im.is_finite();
        is_known.then_some(Phasor { omega: TAU * hz, unit, weight: coherence / (1.0 - coherence) })
    };
    let phasors: Vec<Phasor> = (1..spectra.length / 2).filter_map(phasor).collect();
    (phasors.len() >= FEWEST_LINES).then(|| delay(&phasors)).flatten()
}

/// The information of a line about a delay.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Phasor {
    /// 2 pi f [rad/s]
    pub omega: f64,
    /// exp(-j w tau) with noise
    pub unit: Complex64,
    /// 1/variance of its phase
    pub weight: f64,
}

/// The delay on which the phasors agree; `None` if they do not.
pub(crate) fn delay(phasors: &[Phasor]) -> Option<Time> {
    let score = |tau: f64| {
        let of = |p: &Phasor| p.weight * (p.unit * turned(p.omega * tau)).re;
        phasors.iter().map(of).sum::<f64>()
    };
    let steps = libm::round(LARGEST / STEP);
    let taus: Vec<f64> =
        (0..).map(|k| (f64::from(k) - steps) * STEP).take_while(|tau| *tau <= LARGEST + STEP / 2.0).collect();
    let scores: Vec<f64> = taus.iter().map(|tau| score(*tau)).collect();
    let first = (0..scores.len()).reduce(|best, k| if scores[k] > scores[best] { k } else { best })?;
    let is_maximum = |k: &usize| {
        let (before, after) = (k.checked_sub(1).map(|k| scores[k]), scores.get(k + 1));
        before.is_none_or(|before| scores[*k] >= before) && after.is_none_or(|after| scores[*k] > *after)
    };
    let is_as_good = |k: usize| k != first && scores[k] > AS_GOOD * scores[first];
    if scores[first] <= 0.0 || (0..scores.len()).filter(is_maximum).any(is_as_good) {
        return None;
    }
    let information: f64 = phasors.iter().map(|p| p.weight * p.omega * p.omega).sum();
    let mut tau = taus[first];
    let left = |p: &Phasor, tau: f64| angle(p.unit * turned(p.omega * tau));
    for _ in 0..REFINEMENTS {
        tau -= phasors.iter().map(|p| p.weight * p.omega * left(p, tau)).sum::<f64>() / information;
    }
    let squares: f64 = phasors.iter().map(|p| p.weight * left(p, tau) * left(p, tau)).sum();
    let rms = (squares / phasors.len() as f64).sqrt();
    let error = rms.larger(1.0) / information.sqrt();
    (error <= LARGEST_ERROR && libm::fabs(tau) <= LARGEST + STEP).then_some(Time { seconds: tau, error })
}
