//! The drives with which a proposal must be stable, and the allowed weights: the measured drive, one that is half a cycle
//! later, two with another load.

use crate::response::Lines;
use crate::shape::{Shape, Stages};
use crate::what_if::rest;
use crate::{Complex64, magnitude, turned};
use portable::Extreme;
use stability::{Band, Controller, Drive, LARGEST_WEIGHT, Line, Loop, Points, STAGES, largest_within};
use std::f64::consts::{PI, TAU};

/// Another mass of the load moves the vibrations by these factors: 1/sqrt(1 -+ 15 %).
pub const STRETCHED: [f64; 2] = [1.084_652_289_093_281, 0.932_504_808_240_314];
/// Cycles of delay that are not stretched.
const NOT_STRETCHED: f64 = 1.0;
/// Points: from this part of the lowest f0, with this relative distance.
const LOWEST: f64 = 0.1;
const STEP: f64 = 0.005;
/// The highest point, as a part of the sampling frequency.
const LAST: f64 = 0.499;

/// The measured drive and its variants.
pub struct Scenarios {
    cycle_time: f64,
    position_gain: Option<f64>,
    /// P, half a cycle more, stretched
    pub drives: [stability::Response; 4],
    /// t = tan(pi f T) of the points
    t: Vec<f64>,
    /// 1 + L0, P, two standard errors divided by the magnitude, at the points of each drive
    points: Vec<Vec<(Complex64, Complex64, f64)>>,
}

impl Scenarios {
    /// The scenarios from measured lines at a cycle time T [s]; stages are at the lowest f0 [Hz] or above. `None` if there
    /// is no line.
    ///
    /// ```text
    /// P        P exp(-j w T/2)        P'(f) = R(f/k) exp(-j w T), R = P exp(j w T), k = 1/sqrt(0.85), 1/sqrt(1.15)
    /// ```
    #[must_use]
    pub fn new(lines: &Lines, cycle_time: f64, position_gain: Option<f64>, lowest_f0: f64) -> Option<Self> {
        let drives = changed(lines, cycle_time)?;
        let mut t = Vec::new();
        let mut hz = LOWEST * lowest_f0;
        while hz < LAST / cycle_time {
            t.push(libm::tan(PI * hz * cycle_time));
            hz *= 1.0 + STEP;
        }
        let mut scenarios = Self { cycle_time, position_gain, drives, t, points: Vec::new() };
        scenarios.points = scenarios.drives.iter().map(|drive| scenarios.at_points(drive)).collect();
        Some(scenarios)
    }

    fn at_points(&self, drive: &stability::Response) -> Vec<(Complex64, Complex64, f64)> {
        let axis =
            crate::what_if::Axis { cycle_time: self.cycle_time, position_gain: self.position_gain, response: drive };
        let at = |t: &f64| {
            let hz = libm::atan(*t) / (PI * self.cycle_time);
            let p = drive.value(hz);
            (rest(&axis, *t, p), p, 2.0 * drive.relative_error(hz))
        };
        self.t.iter().map(at).collect()
    }

    /// C at the points, for stages with weights.
    #[must_use]
    pub fn controller(&self, stages: &Stages<'_>, of: &[(Shape, f64)]) -> Vec<Complex64> {
        crate::shape::sum(stages, of, &self.t)
    }

    /// The largest factor of C, up to `most`, up to which every loop is stable and has |S| within its limit, for P within
    /// two standard errors.
    #[must_use]
    pub fn largest_factor(&self, controller: &[Complex64], limits: [f64; 4], most: f64) -> f64 {
        let mut largest = most;
        for (points, limit) in self.points.iter().zip(limits) {
            for ((rest, p, uncertainty), c) in points.iter().zip(controller) {
                let line = Line { rest: *rest, part: -(c * p), uncertainty: *uncertainty };
                largest = largest.smaller(largest_within(&line, 1.0 / limit, largest));
            }
        }
        largest
    }

    /// The largest |S| of each loop with C times a factor, at the points, without errors.
    #[must_use]
    pub fn ms(&self, controller: &[Complex64], factor: f64) -> [f64; 4] {
        let distance = |((rest, p, _), c): (&(Complex64, Complex64, f64), &Complex64)| magnitude(rest - c * p * factor);
        let least = |points: &Vec<_>| points.iter().zip(controller).map(distance).fold(f64::INFINITY, f64::smaller);
        std::array::from_fn(|scenario| 1.0 / least(&self.points[scenario]))
    }

    /// Whether every loop with stages and weights is stable, as computed by the crate `stability` also between all points,
    /// with the measured P. A drive whose loop is unstable without stages is ignored: it runs on the machine, and its lowest
    /// lines are uncertain.
    #[must_use]
    pub fn are_stable(&self, stages: &Stages<'_>, of: &[(Shape, f64)]) -> bool {
        self.stable(controller(stages, of, self.cycle_time, self.position_gain)).into_iter().all(|is_stable| is_stable)
    }

    /// The same of any controller, for each loop.
    #[must_use]
    pub fn stable(&self, controller: Controller<'_>) -> [bool; 4] {
        let drives: Vec<Drive<'_>> = self.drives.iter().map(Drive::Measured).collect();
        let points = Points::new(controller, &drives);
        let is_stable = |scenario: usize| {
            let closed = Loop::new(&points, drives[scenario]);
            closed.is_stable() || !closed.with([0.0; STAGES]).is_stable()
        };
        std::array::from_fn(is_stable)
    }

    /// A response, a function of t = tan(pi f T), at the points.
    pub fn at_places(&self, response: impl Fn(f64) -> Complex64) -> Vec<Complex64> {
        self.t.iter().map(|t| response(*t)).collect()
    }
}

/// The scenarios from lines; `None` if there is no line.
fn changed(lines: &Lines, cycle_time: f64) -> Option<[stability::Response; 4]> {
    let nyquist = 0.5 / cycle_time;
    let changed = |stretch: f64, delay: f64| {
        let kept = lines.up_to(nyquist * 0.999 / stretch);
        let later = |(hz, p): (&f64, &Complex64)| p * turned(-TAU * hz * delay * cycle_time);
        let response = kept.hz.iter().zip(&kept.response).map(later).collect();
        Lines { hz: kept.hz.iter().map(|hz| hz * stretch).collect(), response, ..kept }.response(cycle_time)
    };
    let stretched = |k: f64| changed(k, (k - 1.0) * NOT_STRETCHED);
    Some([changed(1.0, 0.0)?, changed(1.0, 0.5)?, stretched(STRETCHED[0])?, stretched(STRETCHED[1])?])
}

/// The controller of stages with weights, for the crate `stability`.
pub(crate) fn controller<'a>(
    stages: &'a Stages<'_>,
    of: &[(Shape, f64)],
    cycle_time: f64,
    position_gain: Option<f64>,
) -> Controller<'a> {
    let responses: Vec<Box<dyn Fn(f64) -> Complex64 + '_>> = of.iter().map(|(shape, _)| stages(shape)).collect();
    let mut bands = Vec::new();
    for (shape, _) in of {
        bands.push(Band { centre: shape.f0, width: shape.f0 / shape.q });
        bands.extend(shape.allpass.map(|allpass| Band { centre: allpass.f0, width: allpass.f0 / allpass.q }));
    }
    Controller {
        cycle_time,
        weight: std::array::from_fn(|i| of.get(i).map_or(0.0, |(_, weight)| *weight)),
        stage: Box::new(move |t| std::array::from_fn(|i| responses.get(i).map_or(crate::ZERO, |of| of(t)))),
        bands,
        position_gain,
        gain_in_drive: None,
    }
}

/// The largest factor of weights for which none exceeds 7.
#[must_use]
pub fn most(of: &[(Shape, f64)]) -> f64 {
    LARGEST_WEIGHT / of.iter().fold(f64::MIN_POSITIVE, |most, (_, weight)| weight.larger(most))
}

/// The largest number of stages of a proposal.
pub const MOST_STAGES: usize = STAGES;
