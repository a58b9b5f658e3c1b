//! The response of an axis from the periods of its excitation: lines with their standard errors. No dead time, no vibration.

use crate::excitation::Sequence;
use crate::{Complex64, fourier, magnitude, turned};
use nalgebra::{Matrix3, Vector3};
use portable::Extreme;
use std::f64::consts::TAU;

/// The smallest number of periods from which an error can be computed.
pub const FEWEST_PERIODS: usize = 4;
/// Lines of the excitation below this part of its largest are left out.
const WEAKEST: f64 = 1e-3;
/// Half width of the smoothing: as a part of the frequency, and the minimum in lines.
const HALF_WIDTH: f64 = 0.02;
const FEWEST_LINES: f64 = 2.0;
/// Cycles of delay that are removed before lines are interpolated, as in [`stability::Response`].
const TAKEN_OUT: f64 = 2.0;
/// Lower limit of a standard error, as a part of the magnitude: a record without noise has weights too.
const LEAST_ERROR: f64 = 1e-6;
/// Two standard errors, as a part of the magnitude, from which nothing is proposed at a frequency.
pub const LARGEST_UNCERTAINTY: f64 = 0.5;

/// A measured response, line by line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lines {
    /// [Hz], rising
    pub hz: Vec<f64>,
    /// P
    pub response: Vec<Complex64>,
    /// its standard error: the distance in the complex plane
    pub error: Vec<f64>,
    /// from 0 to 1: the part of the measured power that follows the excitation
    pub coherence: Vec<f64>,
}

/// The reason why there is no response.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Refused {
    /// the two signals have different lengths, or not whole periods
    NotPeriods,
    /// fewer than [`FEWEST_PERIODS`]
    TooFewPeriods(usize),
    /// the velocity of the motor changes its sign at this sample: friction acts as another excitation, with a high coherence
    Reverses(usize),
}

impl Lines {
    /// P from the measured periods of an excitation: those after the first one, in which the axis settles.
    ///
    /// U_m, Y_m are the transforms of period m of `v_cmd`, `v_motor`, without a window. The excitation is the instrument, so
    /// that a closed loop causes no bias.
    ///
    /// ```text
    /// P = sum Y_m / sum U_m        e_m = Y_m - P U_m        se^2 = sum |e_m|^2 / (M (M - 1) |mean U|^2)
    /// coherence = max(0, (M |mean Y|^2 / mean |Y|^2 - 1) / (M - 1))
    /// ```
    ///
    /// Lines lie at k/(N T), up to half the sampling frequency, where the excitation has at least 1/1000 of its
    /// largest line.
    ///
    /// # Errors
    /// [`Refused`]
    pub fn measured(sequence: &Sequence, cycle_time: f64, v_cmd: &[f64], v_motor: &[f64]) -> Result<Self, Refused> {
        let lines = Self::of_periods(sequence, cycle_time, v_cmd, v_motor)?;
        let sign = v_motor[0].signum();
        match v_motor.iter().position(|v| v * sign <= 0.0) {
            Some(at) => Err(Refused::Reverses(at)),
            None => Ok(lines),
        }
    }

    /// The response between any two signals while an axis is excited, such as `v_motor` and the acceleration of the load,
    /// which may change their signs.
    ///
    /// # Errors
    /// [`Refused`]
    pub fn of_periods(sequence: &Sequence, cycle_time: f64, from: &[f64], to: &[f64]) -> Result<Self, Refused> {
        let period = sequence.period();
        if from.len() != to.len() || !from.len().is_multiple_of(period) {
            return Err(Refused::NotPeriods);
        }
        let periods = from.len() / period;
        if periods < FEWEST_PERIODS {
            return Err(Refused::TooFewPeriods(periods));
        }
        let transforms = |signal: &[f64]| signal.chunks(period).map(fourier::of_real).collect::<Vec<_>>();
        let (commands, answers) = (transforms(from), transforms(to));
        let largest = (1..=period / 2).map(|k| sequence.line(k)).fold(0.0, f64::larger);
        let mut lines = Self::default();
        for k in (1..=period / 2).filter(|k| sequence.line(*k) >= WEAKEST * largest) {
            let at = |of: &[Vec<Complex64>]| of.iter().map(|lines| lines[k]).collect::<Vec<_>>();
            lines.add(k as f64 * sequence.spacing(cycle_time), &at(&commands), &at(&answers));
        }
        Ok(lines)
    }

    /// Adds a line from its periods.
    fn add(&mut self, hz: f64, commands: &[Complex64], answers: &[Complex64]) {
        let m = commands.len() as f64;
        let [u, y] = [commands, answers].map(|of| of.iter().sum::<Complex64>() / m);
        let p = y / u;
        // A line without excitation contains no information.
        if !(p.re.is_finite() && p.im.is_finite()) {
            return;
        }
        let squares: f64 = commands.iter().zip(answers).map(|(u, y)| (y - p * u).norm_sqr()).sum();
        let power = answers.iter().map(Complex64::norm_sqr).sum::<f64>() / m;
        self.hz.push(hz);
        self.response.push(p);
        self.error.push((squares / (m * (m - 1.0) * u.norm_sqr())).sqrt());
        self.coherence.push(((m * y.norm_sqr() / power - 1.0) / (m - 1.0)).larger(0.0));
    }

    /// The lines up to a frequency [Hz].
    #[must_use]
    pub fn up_to(&self, hz: f64) -> Self {
        let kept = self.hz.partition_point(|line| *line <= hz * (1.0 + 1e-9));
        Self {
            hz: self.hz[..kept].to_vec(),
            response: self.response[..kept].to_vec(),
            error: self.error[..kept].to_vec(),
            coherence: self.coherence[..kept].to_vec(),
        }
    }

    /// The response smoothed over frequency, with the resulting errors.
    ///
    /// R = P exp(j w 2 T) changes slowly. At each line a quadratic in f is fitted to R with the weights (1 - |x|^3)^3 /
    /// se^2, x = distance/(h + 1 line), half width h = max(2 lines, 0.02 f). All lines are kept.
    #[must_use]
    pub fn smoothed(&self, cycle_time: f64) -> Self {
        let turn = |hz: f64| turned(TAU * hz * TAKEN_OUT * cycle_time);
        let straight: Vec<Complex64> = self.hz.iter().zip(&self.response).map(|(f, p)| p * turn(*f)).collect();
        let spacing = self.hz.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::smaller);
        let floor = |k: usize| self.error[k].larger(LEAST_ERROR * magnitude(straight[k]));
        let mut smoothed = self.clone();
        for (k, hz) in self.hz.iter().enumerate() {
            let half = (FEWEST_LINES * spacing).larger(HALF_WIDTH * hz);
            let from = self.hz.partition_point(|line| *line < hz - half * (1.0 + 1e-9));
            let to = self.hz.partition_point(|line| *line <= hz + half * (1.0 + 1e-9));
            let place = |i: usize| {
                let x = (self.hz[i] - hz) / (half + spacing);
                let part = 1.0 - libm::fabs(x * x * x);
                [x, part * part * part / (floor(i) * floor(i))]
            };
            let places: Vec<[f64; 2]> = (from..to).map(place).collect();
            let Some(shares) = shares(&places) else { continue };
            let sum =
                |of: &[Complex64]| of[from..to].iter().zip(&shares).map(|(r, share)| r * share).sum::<Complex64>();
            let squares = self.error[from..to].iter().zip(&shares).map(|(error, share)| error * error * share * share);
            smoothed.response[k] = sum(&straight) * turn(*hz).conj();
            smoothed.error[k] = squares.sum::<f64>().sqrt();
        }
        smoothed
    }

    /// P between its lines and beyond: the cubic spline of the crate `stability`; `None` if there is no line.
    #[must_use]
    pub fn response(&self, cycle_time: f64) -> Option<stability::Response> {
        let is_rising = self.hz.first().is_some_and(|hz| *hz > 0.0) && self.hz.windows(2).all(|pair| pair[0] < pair[1]);
        is_rising.then(|| stability::Response::new(&self.hz, &self.response, &self.error, cycle_time))
    }

    /// The lines of such a response, as from a file. The coherence is unknown, and set to 1.
    #[must_use]
    pub fn of(response: &stability::Response) -> Self {
        let hz = response.frequencies().to_vec();
        let values: Vec<Complex64> = hz.iter().map(|hz| response.value(*hz)).collect();
        let error = hz.iter().zip(&values).map(|(hz, p)| response.relative_error(*hz) * magnitude(*p)).collect();
        Self { coherence: vec![1.0; hz.len()], hz, response: values, error }
    }

    /// The band [Hz] from the first to the last line; `None` if there is no line.
    #[must_use]
    pub fn band(&self) -> Option<[f64; 2]> {
        Some([*self.hz.first()?, *self.hz.last()?])
    }
}

/// The coefficient of each value in the value at 0 of the quadratic through values at places x with weights w; `None` if
/// there are fewer than three places.
fn shares(places: &[[f64; 2]]) -> Option<Vec<f64>> {
    let largest = places.iter().fold(0.0, |largest: f64, [_, w]| largest.larger(*w));
    let term = |[x, w]: &[f64; 2]| {
        let powers = Vector3::new(1.0, *x, x * x);
        Matrix3::from_fn(|i, j| w / largest * powers[i] * powers[j])
    };
    let normal = places.iter().map(term).fold(Matrix3::zeros(), |sum, term| sum + term);
    let at_0 = normal.cholesky()?.solve(&Vector3::new(1.0, 0.0, 0.0));
    Some(places.iter().map(|[x, w]| w / largest * (at_0[0] + x * (at_0[1] + x * at_0[2]))).collect())
}

/// A relative standard error in dB, 20/ln 10 se/|P|, and in degrees, 180/pi se/|P|.
#[must_use]
pub fn in_db_and_degrees(relative_error: f64) -> [f64; 2] {
    [20.0 / std::f64::consts::LN_10 * relative_error, relative_error.to_degrees()]
}

/// Whether a response is too uncertain at a frequency [Hz] to propose anything there: 2 se/|P| >= 0.5.
#[must_use]
pub fn is_too_uncertain(response: &stability::Response, hz: f64) -> bool {
    let uncertainty = 2.0 * response.relative_error(hz);
    uncertainty >= LARGEST_UNCERTAINTY || uncertainty.is_nan()
}
