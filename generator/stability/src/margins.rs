//! A controller with a drive: the stability of their loop, its margins, the largest weights of its stages.

use crate::crossing::Line;
use crate::drive::Value;
use crate::driven::{At, Driven};
use crate::frequency::{Controller, Point, Points};
use crate::part::Part;
use crate::{Complex64, Drive, LARGEST_WEIGHT, STAGES, angle, magnitude};
use portable::Extreme;

/// The largest |S| of a well-damped loop: it implies a gain margin of 6 dB and a phase margin of 29 degrees.
pub const MAX_MS: f64 = 2.0;
/// Larger factors are not searched.
const LARGEST_FACTOR: f64 = 1e6;

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
#[derive(Clone)]
pub struct Loop<'a> {
    controller: &'a Controller<'a>,
    driven: Driven<'a>,
    /// the weights of the stages
    weight: [f64; STAGES],
}

impl<'a> Loop<'a> {
    /// Closes the loop, with the weights of the controller.
    #[must_use]
    pub fn new(points: &'a Points<'a>, drive: Drive<'a>) -> Self {
        let controller = &points.controller;
        Self { controller, driven: Driven::new(points, drive), weight: controller.weight }
    }

    /// The loop with other weights.
    #[must_use]
    pub fn with(&self, weight: [f64; STAGES]) -> Self {
        Self { weight, ..self.clone() }
    }

    /// Whether it is stable with the measured values, without their uncertainty.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.whole().is_stable(1.0)
    }

    /// The angle of a stage and the drive together at a frequency [Hz], in degrees, in (-360, 0].
    #[must_use]
    pub fn phase(&self, stage: usize, hz: f64) -> f64 {
        let at = self.driven.at_hz(hz);
        let degrees = angle(at.0.stage[stage] * at.1.response).to_degrees();
        if degrees > 0.0 { degrees - 360.0 } else { degrees }
    }

    /// The lag of the drive alone at a frequency [Hz], in degrees, from 0 to 360. Its own position controller leads by up to 90.
    #[must_use]
    pub fn lag(&self, hz: f64) -> f64 {
        let at = self.driven.at_hz(hz);
        let degrees = -angle(at.1.response).to_degrees();
        let least = if self.controller.gain_in_drive.is_some() { -90.0 } else { 0.0 };
        if degrees < least { degrees + 360.0 } else { degrees }
    }

    /// The loop at its points.
    #[must_use]
    pub fn curve(&self) -> Vec<Curve> {
        self.driven.all().map(|at| self.curve_at(&at)).collect()
    }

    /// The loop at a frequency [Hz].
    #[must_use]
    pub fn at_frequency(&self, hz: f64) -> Curve {
        self.curve_at(&self.driven.at_hz(hz))
    }

    fn curve_at(&self, (point, value): &At) -> Curve {
        let weight = &self.weight;
        Curve {
            hz: self.controller.hz(point.half),
            open: self.open(point, value, weight),
            stage: std::array::from_fn(|i| point.stage[i] * weight[i]),
            drive: value.response,
        }
    }

    /// What each weight of a stage does, with the stages before it and without those after it: the remaining part of a
    /// disturbance at the motor at a frequency [Hz], which is |S| with the stage divided by |S| without it; and the largest
    /// |S|. `None` if the loop is unstable.
    #[must_use]
    pub fn effects<const N: usize>(&self, stage: usize, hz: f64, weights: [f64; N]) -> [Option<[f64; 2]>; N] {
        let line = self.of_stage(stage, |i| i < stage);
        let at_hz = line(&self.driven.at_hz(hz));
        let part = Part::new(&self.driven, line);
        weights.map(|weight| {
            let left = magnitude(at_hz.rest) / magnitude(at_hz.at(weight));
            part.ms(weight).map(|[ms, _]| [left, ms])
        })
    }

    /// The loop with the whole of L as its part.
    fn whole(&self) -> Part<'_, impl Fn(&At) -> Line> {
        let rest = Complex64::new(1.0, 0.0);
        let part = |(point, value): &At| self.open(point, value, &self.weight);
        Part::new(&self.driven, move |at| Line { rest, part: part(at), uncertainty: at.1.uncertainty })
    }

    /// Its stability, its largest |S|, its margins.
    #[must_use]
    pub fn margins(&self) -> Margins {
        let whole = self.whole();
        let Some([ms, t]) = whole.ms(1.0) else {
            return Margins { stable: whole.is_stable(1.0), ms: None, gain_db: None, phase_deg: None };
        };
        let factor = whole.largest_stable([1.0, LARGEST_FACTOR]);
        let mut phase: Option<f64> = None;
        whole.crossings(
            |line| line.part.norm_sqr() - 1.0,
            |line| {
                let of_error = 2.0 * libm::asin((line.uncertainty / 2.0).smaller(1.0));
                let margin = (angle(-line.part).abs() - of_error).larger(0.0);
                phase = Some(phase.map_or(margin, |least| least.smaller(margin)));
            },
        );
        Margins {
            stable: true,
            ms: Some([ms, self.controller.hz(libm::atan(t))]),
            gain_db: Some(20.0 * libm::log10(factor)).filter(|_| factor < LARGEST_FACTOR),
            phase_deg: phase.map(f64::to_degrees),
        }
    }

    /// The largest weights of a stage with unchanged weights of the others: up to which the loop is stable, and up to which
    /// |S| stays within [`MAX_MS`] too.
    #[must_use]
    pub fn largest_weights(&self, stage: usize) -> [f64; 2] {
        self.largest(self.of_stage(stage, |i| i != stage), LARGEST_WEIGHT)
    }

    /// The same for factors of all weights together.
    #[must_use]
    pub fn largest_parts(&self) -> [f64; 2] {
        let line = |(point, value): &At| {
            let rest = self.open(point, value, &[0.0; STAGES]);
            let part = self.open(point, value, &self.weight) - rest;
            Line { rest: rest + 1.0, part, uncertainty: value.uncertainty }
        };
        self.largest(line, LARGEST_FACTOR)
    }

    /// The largest weights of a part: up to which the loop is stable, and up to which |S| stays within [`MAX_MS`] for all
    /// smaller weights too. 0 if it is unstable without the part.
    fn largest(&self, line: impl Fn(&At) -> Line, most: f64) -> [f64; 2] {
        let part = Part::new(&self.driven, line);
        if !part.is_stable(0.0) {
            return [0.0; 2];
        }
        [part.largest_stable([0.0, most]), part.largest_within(1.0 / MAX_MS, most)]
    }

    /// The loop with one stage as its part, and some of the others.
    fn of_stage(&self, stage: usize, has: impl Fn(usize) -> bool) -> impl Fn(&At) -> Line {
        let weight = std::array::from_fn(|i| if has(i) { self.weight[i] } else { 0.0 });
        move |(point, value)| Line {
            rest: self.open(point, value, &weight) + 1.0,
            part: -(point.stage[stage] * value.response),
            uncertainty: value.uncertainty,
        }
    }

    /// L with these weights.
    fn open(&self, point: &Point, value: &Value, weight: &[f64; STAGES]) -> Complex64 {
        let stages = point.stage.iter().zip(weight).map(|(stage, weight)| stage * weight);
        (point.position - stages.sum::<Complex64>()) * value.response
    }
}
