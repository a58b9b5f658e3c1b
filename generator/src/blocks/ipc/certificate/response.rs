//! Gain and phase of a stage: as its compiled sections have it, and as the formulas of its filters do. No rounding of
//! a coefficient is in the designed values.

use super::super::design::Passband;
use super::chain::{Chain, Section};
use crate::axis::{Filter, Prototype, Stage};
use crate::blocks::designed::Designed;
use crate::design::band::{band, edges, frequency, warped};
use crate::design::prototype::{Pole, poles};
use crate::design::response::{Complex, magnitude};

/// A band-pass of a stage and the response of the whole stage at it.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// index of the filter
    pub filter: usize,
    /// centre, lower and upper -3 dB edge
    pub point: Vec<Point>,
}

/// The response of a stage at one frequency: from the velocity that it looks at to what it adds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// frequency [Hz]
    pub frequency: f64,
    /// by the formulas
    pub designed: Complex,
    /// by the compiled block
    pub measured: Complex,
}

impl Point {
    /// |measured - designed| / |designed|
    #[must_use]
    pub fn deviation(&self) -> f64 {
        let Self { designed, measured, .. } = self;
        magnitude(Complex { re: measured.re - designed.re, im: measured.im - designed.im }) / magnitude(*designed)
    }
}

/// Centre and edges of every band-pass of a chain's stage.
pub(super) fn bands(of: &Designed, chain: &Chain) -> Vec<Band> {
    let cycle_time = of.axis.cycle_time();
    let parts = of.axis.ipc.stage[chain.stage].as_ref().zip(of.ipc.stage[chain.stage].as_ref());
    let (stage, design) = parts.expect("certificate: a chain is one of the axis's stages");
    let band = |(filter, (of, passband)): (usize, (&Filter, &Option<Passband>))| {
        let (Filter::Bandpass { f0, .. }, Some(passband)) = (of, passband) else { return None };
        let at = |(frequency, t)| Point {
            frequency,
            designed: designed(stage, cycle_time, t),
            measured: measured(chain, t),
        };
        let edge = |t| (frequency(t, cycle_time), t);
        let [lower, upper] = edges(&passband.band);
        let point = [(*f0, warped(*f0, cycle_time)), edge(lower), edge(upper)].map(at).to_vec();
        Some(Band { filter, point })
    };
    stage.filter.iter().zip(&design.passband).enumerate().filter_map(band).collect()
}

/// The designed response at t = tan(pi f Ts): -weight, the simulated oscillation, the filters.
///
/// - oscillation: (g^2 + j k g t) / (g^2 - t^2 + j k g t), g the warped f0 of the first band-pass, k = 2 D;
/// - band-pass: its low-pass prototype at w = (t^2 - Omega0^2) / (B t): the product of sigma / (sigma + j w) and of
///   (sigma^2 + omega^2) / (sigma^2 + omega^2 - w^2 + 2 j sigma w);
/// - all-pass: (Omega0^2 - t^2 - j B t) / (Omega0^2 - t^2 + j B t).
#[must_use]
pub(super) fn designed(stage: &Stage, cycle_time: f64, t: f64) -> Complex {
    let mut h = Complex { re: -stage.weight(), im: 0.0 };
    if let Some(damping) = stage.mode.osc_damping() {
        let g = warped(stage.f0(), cycle_time);
        let im = 2.0 * damping * g * t;
        h = product(h, quotient(Complex { re: g * g, im }, Complex { re: (g - t) * (g + t), im }));
    }
    stage.filter.iter().fold(h, |h, filter| match *filter {
        Filter::NoFilter => h,
        Filter::Bandpass { prototype, order, f0, q_factor } => {
            let band = band(f0, q_factor, cycle_time);
            product(h, low_pass(prototype, order, (t - band.omega0) * (t + band.omega0) / (band.bandwidth * t)))
        }
        Filter::Allpass { f0, q_factor } => {
            let band = band(f0, q_factor, cycle_time);
            let (re, im) = ((band.omega0 - t) * (band.omega0 + t), band.bandwidth * t);
            product(h, quotient(Complex { re, im: -im }, Complex { re, im }))
        }
    })
}

fn low_pass(prototype: Prototype, order: usize, w: f64) -> Complex {
    poles(prototype, order).iter().fold(Complex { re: 1.0, im: 0.0 }, |h, pole| {
        let (dc, denominator) = match *pole {
            Pole::Real { sigma } => (sigma, Complex { re: sigma, im: w }),
            Pole::Pair { sigma, omega } => {
                let square = sigma * sigma + omega * omega;
                (square, Complex { re: square - w * w, im: 2.0 * sigma * w })
            }
        };
        product(h, quotient(Complex { re: dc, im: 0.0 }, denominator))
    })
}

/// The response of the compiled sections at t = tan(pi f Ts), where z - 1 = 2 j t / (1 - j t) is known without a
/// cancellation: a low frequency costs no digits here.
#[must_use]
pub(super) fn measured(chain: &Chain, t: f64) -> Complex {
    let step = quotient(Complex { re: 0.0, im: 2.0 * t }, Complex { re: 1.0, im: -t });
    chain.section.iter().fold(Complex { re: chain.gain, im: 0.0 }, |h, section| product(h, of_section(section, step)))
}

/// b0 + (z from_x[0] + from_x[1]) / (z^2 + a1 z + a2), z = 1 + `step`.
fn of_section(section: &Section, step: Complex) -> Complex {
    let Section { b0, a1, a2, from_x } = *section;
    let numerator = Complex { re: step.re * from_x[0] + (from_x[0] + from_x[1]), im: step.im * from_x[0] };
    let square = product(step, step);
    let re = square.re + step.re * (2.0 + a1) + ((1.0 + a1) + a2);
    let state = quotient(numerator, Complex { re, im: square.im + step.im * (2.0 + a1) });
    Complex { re: b0 + state.re, im: state.im }
}

fn product(a: Complex, b: Complex) -> Complex {
    Complex { re: a.re * b.re - a.im * b.im, im: a.re * b.im + a.im * b.re }
}

fn quotient(a: Complex, b: Complex) -> Complex {
    let square = b.re * b.re + b.im * b.im;
    Complex { re: (a.re * b.re + a.im * b.im) / square, im: (a.im * b.re - a.re * b.im) / square }
}
