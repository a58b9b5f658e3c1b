//! Gain and phase of a stage: as its compiled sections have it, and as the formulas of its filters do. No rounding of
//! a coefficient is in the designed values.

use super::super::stage::{FilterDesign, StageDesign};
use super::chain::Chain;
use super::section::{Biquad, Section};
use crate::axis::{Filter, Prototype};
use crate::design::band::{edges, frequency, warped};
use crate::design::bandpass::{Pole, poles};
use crate::design::response::{Complex, magnitude, product, quotient};

/// The response of a stage at one frequency: from the velocity that it looks at to what it adds.
pub(crate) struct Point {
    /// frequency [Hz]
    pub frequency: f64,
    /// by the formulas
    pub designed: Complex,
    /// by the compiled block
    pub measured: Complex,
}

impl Point {
    /// |measured - designed| / |designed|
    pub(crate) fn deviation(&self) -> f64 {
        let Self { designed, measured, .. } = self;
        magnitude(Complex { re: measured.re - designed.re, im: measured.im - designed.im }) / magnitude(*designed)
    }
}

/// The index of a stage with centre, lower and upper -3 dB edge, for each of its band-passes.
pub(super) fn bands(of: &StageDesign, chain: &Chain) -> Vec<(usize, [Point; 3])> {
    let point = |frequency, t| Point { frequency, designed: designed(of, t), measured: measured(chain, t) };
    let edge = |t| point(frequency(t, of.cycle_time), t);
    let band = |filter: &FilterDesign| {
        let Filter::Bandpass { f0, .. } = filter.filter else { return None };
        let [lower, upper] = edges(&filter.band).map(edge);
        Some((of.index, [point(f0, warped(f0, of.cycle_time)), lower, upper]))
    };
    of.filter.iter().flatten().filter_map(band).collect()
}

/// The designed response at t = tan(pi f Ts): -weight, the simulated oscillation, the filters.
///
/// - oscillation: (g^2 + j k g t) / (g^2 - t^2 + j k g t), g the warped f0 of the first band-pass, k = 2 D;
/// - band-pass: its low-pass prototype at w = (t^2 - Omega0^2) / (B t): the product of sigma / (sigma + j w) and of
///   (sigma^2 + omega^2) / (sigma^2 + omega^2 - w^2 + 2 j sigma w);
/// - all-pass: (Omega0^2 - t^2 - j B t) / (Omega0^2 - t^2 + j B t).
pub(crate) fn designed(of: &StageDesign, t: f64) -> Complex {
    let stage = &of.stage;
    let mut h = Complex::real(-stage.weight());
    if let Some(damping) = stage.mode.osc_damping() {
        let g = warped(stage.f0(), of.cycle_time);
        let im = 2.0 * damping * g * t;
        h = product(h, quotient(Complex { re: g * g, im }, Complex { re: (g - t) * (g + t), im }));
    }
    for FilterDesign { filter, band, .. } in of.filter.iter().flatten() {
        let (omega0, im) = (band.omega0, band.bandwidth * t);
        h = match *filter {
            Filter::Bandpass { prototype, order, .. } => {
                product(h, low_pass(prototype, order, (t - omega0) * (t + omega0) / im))
            }
            _ => {
                let re = (omega0 - t) * (omega0 + t);
                product(h, quotient(Complex { re, im: -im }, Complex { re, im }))
            }
        };
    }
    h
}

fn low_pass(prototype: Prototype, order: usize, w: f64) -> Complex {
    poles(prototype, order).iter().fold(Complex::ONE, |h, pole| {
        let (dc, denominator) = match *pole {
            Pole::Real { sigma } => (sigma, Complex { re: sigma, im: w }),
            Pole::Pair { sigma, omega } => {
                let square = sigma * sigma + omega * omega;
                (square, Complex { re: square - w * w, im: 2.0 * sigma * w })
            }
        };
        product(h, quotient(Complex::real(dc), denominator))
    })
}

/// The response of the compiled sections at t = tan(pi f Ts).
fn measured(chain: &Chain, t: f64) -> Complex {
    chain.section.iter().fold(Complex::real(chain.gain), |h, section| product(h, of_section(section, t)))
}

fn of_section(section: &Section, t: f64) -> Complex {
    match section {
        Section::Biquad(section) => of_biquad(section, t),
        Section::Trapezoidal(section) => section.response(t),
    }
}

/// b0 + (z from_x[0] + from_x[1]) / (z^2 + a1 z + a2), z = 1 + step, where step = 2 j t / (1 - j t) is known without a
/// cancellation: a low frequency costs no digits here.
fn of_biquad(section: &Biquad, t: f64) -> Complex {
    let step = quotient(Complex { re: 0.0, im: 2.0 * t }, Complex { re: 1.0, im: -t });
    let Biquad { b0, a1, a2, from_x } = *section;
    let numerator = Complex { re: step.re * from_x[0] + (from_x[0] + from_x[1]), im: step.im * from_x[0] };
    let square = product(step, step);
    let re = square.re + step.re * (2.0 + a1) + ((1.0 + a1) + a2);
    let state = quotient(numerator, Complex { re, im: square.im + step.im * (2.0 + a1) });
    Complex { re: b0 + state.re, im: state.im }
}
