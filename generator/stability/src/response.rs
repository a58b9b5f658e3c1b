//! A measured response: lines with their standard errors, interpolation between them and extrapolation beyond.

use crate::drive::Value;
use crate::{Complex64, angle, magnitude, turned};
use std::f64::consts::TAU;

/// Cycles of delay that are removed before the lines are interpolated, and restored afterwards: the rest changes slowly.
const TAKEN_OUT: f64 = 2.0;

/// The response from the commanded velocity to the motor's. All its lines are used, with their errors.
///
/// Between the lines a cubic spline interpolates P exp(j 2 pi f 2 T). Below the lowest line magnitude and phase are linear
/// to 1 and 0 at 0 Hz. Above the highest line the last value is used, turned by the same delay.
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    hz: Vec<f64>,
    /// the lines without the delay, and their second derivatives over Hz
    lines: Vec<[Complex64; 2]>,
    /// standard errors, relative to the magnitudes
    error: Vec<f64>,
    /// the lowest line
    lowest: Complex64,
    /// [s]
    delay: f64,
    /// the position loop of the drive: its gain [1/s], and the part of P that is a delay before it [s]
    position: Option<[f64; 2]>,
}

impl Response {
    /// Lines at rising frequencies above 0 [Hz], with their standard errors, at the cycle time T [s].
    ///
    /// # Panics
    /// If the arrays differ in length, are empty, or the frequencies do not rise.
    #[must_use]
    pub fn new(hz: &[f64], response: &[Complex64], standard_error: &[f64], cycle_time: f64) -> Self {
        assert!(hz.len() == response.len() && hz.len() == standard_error.len(), "one response and one error a line");
        assert!(hz.first().is_some_and(|first| *first > 0.0), "lines above 0 Hz");
        assert!(hz.windows(2).all(|pair| pair[0] < pair[1]), "rising frequencies");
        let delay = TAKEN_OUT * cycle_time;
        let straight: Vec<Complex64> = hz.iter().zip(response).map(|(f, p)| p * turned(TAU * f * delay)).collect();
        let lines = straight.iter().zip(bends(hz, &straight)).map(|(value, bend)| [*value, bend]).collect();
        let error = response.iter().zip(standard_error).map(|(p, error)| error / magnitude(*p)).collect();
        Self { hz: hz.to_vec(), lines, error, lowest: response[0], delay, position: None }
    }

    /// The same drive, if it controls the position with this gain Kv [1/s], from an additive velocity: P/(1 + Kv P0/(j w)), P0
    /// is P without its delay on the bus [s].
    #[must_use]
    pub fn in_position_loop(self, gain: f64, delay: f64) -> Self {
        Self { position: Some([gain, delay]), ..self }
    }

    /// The frequencies of its lines [Hz].
    #[must_use]
    pub fn frequencies(&self) -> &[f64] {
        &self.hz
    }

    /// The response at a frequency [Hz].
    #[must_use]
    pub fn value(&self, hz: f64) -> Complex64 {
        self.at(hz).response
    }

    /// Its standard error there, relative to its magnitude.
    #[must_use]
    pub fn relative_error(&self, hz: f64) -> f64 {
        self.at(hz).uncertainty / 2.0
    }

    pub(crate) fn at(&self, hz: f64) -> Value {
        let above = self.hz.partition_point(|line| *line <= hz);
        let last = self.hz.len() - 1;
        let delayed = |value: Complex64| value * turned(-TAU * hz * self.delay);
        let (response, error) = if above == 0 {
            let part = hz / self.hz[0];
            let magnitude = 1.0 + part * (magnitude(self.lowest) - 1.0);
            (turned(part * angle(self.lowest)) * magnitude, self.error[0] * part)
        } else if above > last {
            (delayed(self.lines[last][0]), self.error[last])
        } else {
            let (from, to) = (self.hz[above - 1], self.hz[above]);
            let part = (hz - from) / (to - from);
            let error = self.error[above - 1] + part * (self.error[above] - self.error[above - 1]);
            (delayed(between(self.lines[above - 1], self.lines[above], to - from, part)), error)
        };
        let Some([gain, delay]) = self.position else { return Value { response, uncertainty: 2.0 * error } };
        let s = Complex64::new(0.0, TAU * hz);
        let left = s / (s + response * turned(TAU * hz * delay) * gain);
        Value { response: response * left, uncertainty: 2.0 * error * magnitude(left) }
    }
}

/// The cubic between two lines with these second derivatives.
fn between([a, bend_a]: [Complex64; 2], [b, bend_b]: [Complex64; 2], width: f64, part: f64) -> Complex64 {
    let rest = 1.0 - part;
    let square = width * width / 6.0;
    a * rest
        + b * part
        + bend_a * (square * (rest * rest * rest - rest))
        + bend_b * (square * (part * part * part - part))
}

/// Second derivatives of the natural cubic spline through the lines: 0 at both ends, a tridiagonal system between.
fn bends(hz: &[f64], lines: &[Complex64]) -> Vec<Complex64> {
    let n = lines.len();
    let mut bends = vec![Complex64::new(0.0, 0.0); n];
    let mut upper = vec![0.0; n];
    for k in 1..n.max(1) - 1 {
        let [below, above] = [hz[k] - hz[k - 1], hz[k + 1] - hz[k]];
        let slope = (lines[k + 1] - lines[k]) / above - (lines[k] - lines[k - 1]) / below;
        let pivot = 2.0 * (below + above) - below * upper[k - 1];
        upper[k] = above / pivot;
        bends[k] = (slope * 6.0 - bends[k - 1] * below) / pivot;
    }
    for k in (1..n.max(1) - 1).rev() {
        let next = bends[k + 1];
        bends[k] -= next * upper[k];
    }
    bends
}
