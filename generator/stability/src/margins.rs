//! A controller with a drive: the stability of their loop, its margins, the largest weights of its stages.

use crate::crossing::Line;
use crate::drive::Value;
use crate::frequency::{Point, Points};
use crate::search::{least, root};
use crate::{Complex64, Drive, LARGEST_WEIGHT, STAGES, angle, magnitude};
use portable::Extreme;
use std::f64::consts::{FRAC_PI_2, PI};

/// The largest |S| of a well-damped loop: it implies a gain margin of 6 dB and a phase margin of 29 degrees.
pub const MAX_MS: f64 = 2.0;
/// Larger factors are not searched.
const LARGEST_FACTOR: f64 = 1e6;
/// Halvings of an interval in which 1 + L changes by more than a quarter turn.
const DEPTH: u32 = 40;
/// A local minimum within this factor of the least one may be the least one between the points: where two stages and the
/// position controller interact, a point exceeded the minimum next to it by a half.
const NEAR: f64 = 4.0;

/// Figures of a closed loop. Each is the worst within two standard errors of a measured response.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margins {
    pub stable: bool,
    /// largest |S| and its frequency [Hz]; `None` if the loop is unstable
    pub ms: Option<[f64; 2]>,
    /// least factor above 1 of L that makes the loop unstable [dB]; `None` if there is no such factor, or if the loop is
    /// unstable
    pub gain_db: Option<f64>,
    /// least phase change of L that makes the loop unstable [degrees]; `None` if there is no such change, or if the loop is
    /// unstable
    pub phase_deg: Option<f64>,
}

/// A loop at a frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    /// [Hz]
    pub hz: f64,
    /// L
    pub open: Complex64,
    /// each stage with its weight
    pub stage: [Complex64; STAGES],
    /// P
    pub drive: Complex64,
}

/// A controller with a drive.
pub struct Loop<'a> {
    points: &'a Points<'a>,
    drive: Drive<'a>,
    /// the weights of the stages
    weight: [f64; STAGES],
    /// P at the points
    values: Vec<Value>,
}

/// A point with P at it.
type At = (Point, Value);

impl<'a> Loop<'a> {
    /// Closes the loop, with the weights of the controller.
    #[must_use]
    pub fn new(points: &'a Points<'a>, drive: Drive<'a>) -> Self {
        let values = points.points.iter().map(|point| drive.at(&points.controller, point)).collect();
        Self { points, drive, weight: points.controller.weight, values }
    }

    /// The weights of the stages.
    #[must_use]
    pub fn weights(&self) -> [f64; STAGES] {
        self.weight
    }

    /// The loop with other weights.
    #[must_use]
    pub fn with(&self, weight: [f64; STAGES]) -> Self {
        Self { weight, values: self.values.clone(), ..*self }
    }

    /// Whether it is stable with the measured values, without their uncertainty.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.is_stable_with(&self.weight)
    }

    /// The angle of a stage and the drive together at a frequency [Hz], in degrees, in (-360, 0].
    #[must_use]
    pub fn phase(&self, stage: usize, hz: f64) -> f64 {
        let at = self.at_t(libm::tan(PI * hz * self.points.controller.cycle_time));
        let degrees = angle(at.0.stage[stage] * at.1.response).to_degrees();
        if degrees > 0.0 { degrees - 360.0 } else { degrees }
    }

    /// The lag of the drive alone at a frequency [Hz], in degrees, from 0 to 360.
    #[must_use]
    pub fn lag(&self, hz: f64) -> f64 {
        let at = self.at_t(libm::tan(PI * hz * self.points.controller.cycle_time));
        let degrees = -angle(at.1.response).to_degrees();
        if degrees < 0.0 { degrees + 360.0 } else { degrees }
    }

    /// The loop at its points.
    #[must_use]
    pub fn curve(&self) -> Vec<Curve> {
        self.all().map(|at| self.curve_at(&at)).collect()
    }

    /// The loop at a frequency [Hz].
    #[must_use]
    pub fn at_frequency(&self, hz: f64) -> Curve {
        self.curve_at(&self.at_t(libm::tan(PI * hz * self.points.controller.cycle_time)))
    }

    fn curve_at(&self, (point, value): &At) -> Curve {
        let weight = &self.weight;
        Curve {
            hz: self.points.controller.hz(point),
            open: self.open(point, value, weight),
            stage: std::array::from_fn(|i| point.stage[i] * weight[i]),
            drive: value.response,
        }
    }

    /// The remaining part of a disturbance at the motor at a frequency [Hz]: |S| with a stage divided by |S| without it.
    #[must_use]
    pub fn left(&self, stage: usize, hz: f64) -> f64 {
        let line = self.line(&self.at_t(libm::tan(PI * hz * self.points.controller.cycle_time)), stage);
        magnitude(line.rest) / magnitude(line.rest + line.part * self.weight[stage])
    }

    /// The largest |S| and its frequency [Hz]; `None` if the loop is unstable.
    #[must_use]
    pub fn ms(&self) -> Option<[f64; 2]> {
        let (distance, at) = self.least(|at| self.whole(at).distance(1.0));
        (distance > 0.0 && self.is_stable()).then(|| [1.0 / distance, self.points.controller.hz(&at.0)])
    }

    /// The loop with the whole of L as its part.
    fn whole(&self, (point, value): &At) -> Line {
        Line {
            rest: Complex64::new(1.0, 0.0),
            part: self.open(point, value, &self.weight),
            uncertainty: value.uncertainty,
        }
    }

    /// Its stability, its largest |S|, its margins.
    #[must_use]
    pub fn margins(&self) -> Margins {
        let Some(ms) = self.ms() else {
            return Margins { stable: self.is_stable(), ms: None, gain_db: None, phase_deg: None };
        };
        let factor = self.largest_stable(|at| self.whole(at), [1.0, LARGEST_FACTOR]);
        let mut phase: Option<f64> = None;
        self.crossings(
            |at| self.whole(at).part.norm_sqr() - 1.0,
            |at| {
                let of_error = 2.0 * libm::asin((at.1.uncertainty / 2.0).smaller(1.0));
                let margin = (angle(-self.whole(at).part).abs() - of_error).larger(0.0);
                phase = Some(phase.map_or(margin, |least| least.smaller(margin)));
            },
        );
        Margins {
            stable: true,
            ms: Some(ms),
            gain_db: Some(20.0 * libm::log10(factor)).filter(|_| factor < LARGEST_FACTOR),
            phase_deg: phase.map(f64::to_degrees),
        }
    }

    /// The largest weight of a stage up to which the loop is stable, with unchanged weights of the others.
    #[must_use]
    pub fn largest_stable_weight(&self, stage: usize) -> f64 {
        if !self.is_stable_with(&self.without(stage)) {
            return 0.0;
        }
        self.largest_stable(|at| self.line(at, stage), [0.0, LARGEST_WEIGHT])
    }

    /// The largest weight of a stage up to which the loop is stable and |S| stays within [`MAX_MS`], with unchanged weights
    /// of the others.
    #[must_use]
    pub fn largest_weight(&self, stage: usize) -> f64 {
        if !self.is_stable_with(&self.without(stage)) {
            return 0.0;
        }
        self.largest(|at| self.line(at, stage), LARGEST_WEIGHT)
    }

    /// The largest factors of all weights together, up to which the loop is stable, and up to which |S| stays within
    /// [`MAX_MS`].
    #[must_use]
    pub fn largest_parts(&self) -> [f64; 2] {
        let whole = |at: &At| {
            let rest = self.open(&at.0, &at.1, &[0.0; STAGES]);
            let part = self.open(&at.0, &at.1, &self.weight) - rest;
            Line { rest: rest + 1.0, part, uncertainty: at.1.uncertainty }
        };
        if !self.is_stable_with(&[0.0; STAGES]) {
            return [0.0; 2];
        }
        [self.largest_stable(whole, [0.0, LARGEST_FACTOR]), self.largest(whole, LARGEST_FACTOR)]
    }

    fn without(&self, stage: usize) -> [f64; STAGES] {
        let mut weight = self.weight;
        weight[stage] = 0.0;
        weight
    }

    /// The largest weight of a part, above `least` and up to `most`, up to which a loop stays stable that is stable with
    /// `least`.
    fn largest_stable(&self, line: impl Fn(&At) -> Line, [least, most]: [f64; 2]) -> f64 {
        let mut largest = most;
        self.crossings(
            |at| line(at).side(),
            |at| {
                let nearest = line(at).nearest();
                if nearest > least {
                    largest = largest.smaller(nearest);
                }
            },
        );
        if self.is_uncertain() {
            largest = largest.smaller(self.least(|at| line(at).largest_weight(0.0, most)).0);
        }
        largest
    }

    /// The largest weight of a part up to which the loop stays stable and |S| within [`MAX_MS`], for all smaller weights
    /// too.
    fn largest(&self, line: impl Fn(&At) -> Line, most: f64) -> f64 {
        self.least(|at| line(at).largest_weight(1.0 / MAX_MS, most)).0
    }

    /// The loop with one stage as its part.
    fn line(&self, (point, value): &At, stage: usize) -> Line {
        Line {
            rest: self.open(point, value, &self.without(stage)) + 1.0,
            part: -(point.stage[stage] * value.response),
            uncertainty: value.uncertainty,
        }
    }

    /// L with these weights.
    fn open(&self, point: &Point, value: &Value, weight: &[f64; STAGES]) -> Complex64 {
        let stages = point.stage.iter().zip(weight).map(|(stage, weight)| stage * weight);
        (point.position - stages.sum::<Complex64>()) * value.response
    }

    fn is_uncertain(&self) -> bool {
        matches!(self.drive, Drive::Measured(_))
    }

    /// Whether 1 + L makes no turn around 0, from 0 Hz to half the sampling frequency. A position controller has its pole at
    /// 0 Hz; the path around it begins on the right, with the angle of 1 + L at the first point.
    fn is_stable_with(&self, weight: &[f64; STAGES]) -> bool {
        if self.points.controller.position_gain.is_none() && weight.iter().all(|weight| *weight <= 0.0) {
            return true;
        }
        let of = |(point, value): &At| self.open(point, value, weight) + 1.0;
        let mut last: Option<(At, Complex64)> = None;
        let mut turned = 0.0;
        for at in self.all() {
            let value = of(&at);
            turned += match last {
                None => angle(value),
                Some(last) => self.turn(&of, last, (at, value), DEPTH),
            };
            last = Some((at, value));
        }
        libm::fabs(turned) < FRAC_PI_2
    }

    /// The change of a value's angle from one point to the next.
    fn turn(&self, of: &impl Fn(&At) -> Complex64, a: (At, Complex64), b: (At, Complex64), depth: u32) -> f64 {
        let turned = angle(b.1 * a.1.conj());
        if libm::fabs(turned) < FRAC_PI_2 || depth == 0 {
            return turned;
        }
        let point = self.points.controller.middle(&a.0.0, &b.0.0);
        let middle = self.at(point);
        let middle = (middle, of(&middle));
        self.turn(of, a, middle, depth - 1) + self.turn(of, middle, b, depth - 1)
    }

    fn at(&self, point: Point) -> At {
        (point, self.drive.at(&self.points.controller, &point))
    }

    fn at_t(&self, t: f64) -> At {
        self.at(self.points.controller.at(t))
    }

    fn all(&self) -> impl Iterator<Item = At> {
        self.points.points.iter().copied().zip(self.values.iter().copied())
    }

    /// The least value over all frequencies, and its place: at the points, then between the neighbours of those that are
    /// almost the least.
    fn least(&self, of: impl Fn(&At) -> f64) -> (f64, At) {
        let values: Vec<f64> = self.all().map(|at| of(&at)).collect();
        let t = |k: usize| self.points.points[k].t;
        let (mut found, mut at) = (f64::INFINITY, t(0));
        for (k, value) in values.iter().enumerate() {
            if *value < found {
                (found, at) = (*value, t(k));
            }
        }
        let near = found * NEAR;
        for (k, window) in values.windows(3).enumerate() {
            let is_least = window[1] <= window[0] && window[1] <= window[2] && window[1] < window[0].larger(window[2]);
            if is_least && window[1] <= near {
                let (t, value) = least(t(k), t(k + 2), |t| of(&self.at_t(t)));
                if value < found {
                    (found, at) = (value, t);
                }
            }
        }
        (found, self.at_t(at))
    }

    /// Calls `found` at each sign change of a function of the frequency.
    fn crossings(&self, of: impl Fn(&At) -> f64, mut found: impl FnMut(&At)) {
        let mut last: Option<(f64, f64)> = None;
        for at in self.all() {
            let (t, value) = (at.0.t, of(&at));
            if let Some((from, before)) = last.filter(|(_, before)| (*before < 0.0) != (value < 0.0)) {
                found(&self.at_t(root([from, t], [before, value], |t| of(&self.at_t(t)))));
            }
            last = Some((t, value));
        }
    }
}
