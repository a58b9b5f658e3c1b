//! Gain and phase of a stage: from its compiled sections, and from the formulas of its filters. The designed values contain
//! no rounding of a coefficient.

use super::super::filter as kinds;
use super::super::filter::FilterDesign;
use super::super::stage::StageDesign;
use super::chain::Chain;
use super::section::{Biquad, Section};
use crate::design::band::{edges, frequency, warped};
use crate::design::response::{Complex, magnitude};
use crate::design::rounding::in_precision;
use crate::design::trapezoidal::Trapezoidal;
use portable::Extreme;
use portable::RealKind;

/// The response of a stage at one frequency, from its input velocity to its output.
pub struct Point {
    /// frequency [Hz]
    pub frequency: f64,
    /// from the formulas
    pub designed: Complex,
    /// from the compiled block
    pub measured: Complex,
    /// from the coefficients of single precision before and after their rounding; `None` in double precision
    pub single: Option<[Complex; 2]>,
}

impl Point {
    /// |measured - designed| / |designed|
    pub(crate) fn deviation(&self) -> f64 {
        relative(self.measured, self.designed)
    }

    /// The deviation without the rounding to single precision: from the formulas to the coefficients, and from the rounded
    /// coefficients to the block.
    pub fn defect(&self) -> f64 {
        match self.single {
            None => self.deviation(),
            Some([exact, rounded]) => relative(exact, self.designed).larger(relative(self.measured, rounded)),
        }
    }
}

/// The response of a stage about one of its filters.
pub struct Band {
    /// the index of the stage
    pub stage: usize,
    /// whether the filter is selective: its points are shown
    pub is_shown: bool,
    /// centre, lower and upper edge
    pub points: [Point; 3],
}

/// The response of a stage about each of its filters.
pub(super) fn bands(of: &StageDesign, chain: &Chain, real: RealKind) -> Vec<Band> {
    let point = |frequency, t| Point {
        frequency,
        designed: designed(of, t),
        measured: measured(chain, t),
        single: (real == RealKind::F32).then(|| single(of, t)),
    };
    let edge = |t| point(frequency(t, of.cycle_time), t);
    let band = |filter: &FilterDesign| {
        let f0 = filter.filter.f0()?;
        let [lower, upper] = edges(&filter.band).map(edge);
        let centre = point(f0, warped(f0, of.cycle_time));
        let is_shown = kinds::is_selective(&filter.filter);
        Some(Band { stage: of.index, is_shown, points: [centre, lower, upper] })
    };
    of.filter.iter().flatten().filter_map(band).collect()
}

/// The designed response at t = tan(pi f Ts): -weight, the simulated oscillation, the filters.
///
/// The oscillation is (g^2 + j k g t) / (g^2 - t^2 + j k g t), g the warped f0 of the first band-pass, k = 2 D. The formula
/// of a filter is in the file of its type ([`kinds`]).
pub(crate) fn designed(of: &StageDesign, t: f64) -> Complex {
    let stage = &of.stage;
    let mut h = Complex::from(-stage.weight());
    if let Some(damping) = stage.mode.osc_damping() {
        let g = warped(stage.f0(), of.cycle_time);
        let im = 2.0 * damping * g * t;
        h *= Complex { re: g * g, im } / Complex { re: (g - t) * (g + t), im };
    }
    for FilterDesign { filter, band, .. } in of.filter.iter().flatten() {
        let kind = kinds::of(filter).expect("certificate: a designed filter has a type");
        h *= kind.response(band, t);
    }
    h
}

/// The response from the coefficients of single precision, before and after their rounding.
fn single(of: &StageDesign, t: f64) -> [Complex; 2] {
    let gain = of.coeffs.gain;
    let by = |gain: f64, section: fn(&super::super::stage::Section) -> &Trapezoidal| {
        of.section.iter().fold(Complex::from(gain), |h, of| h * section(of).response(t))
    };
    [by(gain, |of| &of.unrounded), by(in_precision(gain, RealKind::F32), |of| &of.trapezoidal)]
}

/// |a - b| / |b|
fn relative(a: Complex, b: Complex) -> f64 {
    magnitude(Complex { re: a.re - b.re, im: a.im - b.im }) / magnitude(b)
}

/// The response of the compiled sections at t = tan(pi f Ts).
fn measured(chain: &Chain, t: f64) -> Complex {
    chain.section.iter().fold(Complex::from(chain.gain), |h, section| h * of_section(section, t))
}

fn of_section(section: &Section, t: f64) -> Complex {
    match section {
        Section::Biquad(section) => of_biquad(section, t),
        Section::Trapezoidal(section) => section.response(t),
    }
}

/// b0 + (z from_x[0] + from_x[1]) / (z^2 + a1 z + a2), z = 1 + step, where step = 2 j t / (1 - j t) is computed without
/// cancellation: a low frequency loses no digits here.
fn of_biquad(section: &Biquad, t: f64) -> Complex {
    let step = Complex { re: 0.0, im: 2.0 * t } / Complex { re: 1.0, im: -t };
    let Biquad { b0, a1, a2, from_x } = *section;
    let numerator = Complex { re: step.re * from_x[0] + (from_x[0] + from_x[1]), im: step.im * from_x[0] };
    let square = step * step;
    let re = square.re + step.re * (2.0 + a1) + ((1.0 + a1) + a2);
    let state = numerator / Complex { re, im: square.im + step.im * (2.0 + a1) };
    Complex { re: b0 + state.re, im: state.im }
}
