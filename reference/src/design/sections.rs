//! Second-order sections: from centre and damping to coefficients. No filter, no pole.
//!
//! As biquads, for double precision, all of them have the denominator of [`denominator`]; a0 = 1. `preset` is the state for
//! a constant input of 1. For single precision they have the coefficients of [`trapezoidal`].

use crate::filter::MAX_ORDER;
use crate::{allpass, bandpass, oscillation};
use portable::{Real, copy, portable};

/// A section before the transform s = (1 - z^-1) / (1 + z^-1).
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Shape<R> {
    /// centre on the warped frequency axis: tan(pi f Ts)
    pub g: R,
    /// reciprocal of the section's quality factor
    pub k: R,
    /// gain at the section's own centre
    pub c: R,
}

/// The sections of a filter, in the order of their execution. An all-pass has one, a band-pass one for each order.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Shapes<R> {
    /// the sections
    pub section: [Shape<R>; MAX_ORDER],
}

/// A denominator 1 + a1 z^-1 + a2 z^-2, with the signs of `y = x - a1 y' - a2 y''`.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Denominator<R> {
    /// 2 (g^2 - 1) / d
    pub a1: R,
    /// (1 - k g + g^2) / d
    pub a2: R,
    /// d = 1 + k g + g^2: a numerator is divided by it
    pub d: R,
}

/// A band-pass part c k g s / (s^2 + k g s + g^2) by the trapezoidal rule.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Trapezoidal<R> {
    /// A = c k g / d
    pub a: R,
    /// B = 2 (g + k) g / d
    pub b: R,
    /// C = 2 g / (c k)
    pub c: R,
}

/// A band-pass c k g s / (s^2 + k g s + g^2), with the signs of `y = -b2 x + s1; s1 = s2 - a1 y; s2 = b2 x - a2 y`.
///
/// b0 = c k g / d, b1 = 0, b2 = -b0, which alone is kept.
#[portable]
pub fn bandpass_numbers<R: Real>(coeffs: &mut bandpass::Coeffs<R>, shape: &Shape<R>) {
    let mut of = Denominator::<R>::default();
    denominator(&mut of, shape);
    coeffs.b2 = -(shape.c * shape.k * shape.g / of.d);
    copy!(coeffs = of: a1, a2);
    let mut part = Trapezoidal::<R>::default();
    trapezoidal(&mut part, shape);
    copy!(coeffs = part: a, b, c);
}

/// An all-pass, with the signs of `y = a2 x + s1; s1 = a1 x - a1 y; s2 = x - a2 y`: a1 and a2 are those of the band-pass of
/// order 1 in the same band.
#[portable]
pub fn allpass_numbers<R: Real>(coeffs: &mut allpass::Coeffs<R>, shape: &Shape<R>) {
    let mut of = Denominator::<R>::default();
    denominator(&mut of, shape);
    copy!(coeffs = of: a1, a2);
    coeffs.preset = R::ONE - of.a2;
    let mut part = Trapezoidal::<R>::default();
    trapezoidal(&mut part, shape);
    copy!(coeffs = part: a, b, c);
}

/// The simulated oscillation (k g s + g^2) / (s^2 + k g s + g^2), with the signs of
/// `y = b0 x + s1; s1 = b1 x - a1 y + s2; s2 = b2 x - a2 y`.
///
/// b0 = (k g + g^2) / d, b1 = 2 g^2 / d, b2 = (g^2 - k g) / d. The presets are differences of the rounded numbers: with these
/// numbers the state is then steady.
#[portable]
pub fn oscillation_numbers<R: Real>(coeffs: &mut oscillation::Coeffs<R>, shape: &Shape<R>) {
    let mut of = Denominator::<R>::default();
    denominator(&mut of, shape);
    let g = shape.g;
    let k = shape.k;
    let b0 = (g + k) * g / of.d;
    let b2 = (g - k) * g / of.d;
    coeffs.b0 = b0;
    coeffs.b1 = R::lit(2.0) * g * g / of.d;
    coeffs.b2 = b2;
    copy!(coeffs = of: a1, a2);
    coeffs.preset_s1 = R::ONE - b0;
    coeffs.preset_s2 = b2 - of.a2;
    coeffs.h = R::ONE / of.d;
    coeffs.r = R::lit(2.0) * (g + k) / of.d;
    coeffs.g = g;
    coeffs.g2 = R::lit(2.0) * g;
}

/// A, B and C of the band-pass part c k g s / (s^2 + k g s + g^2), s = (1 - z^-1) / (1 + z^-1), with the signs of
/// `u = A p - B s1; s1' = s1 + u; y = s1 + s1'; p = p - C y`.
///
/// h = 1 / d, d = 1 + k g + g^2: A = g h c k, B = 2 (g + k) g h, C = 2 g / (c k). From the state-variable filter with
/// the integrators i1 and i2, hp = (x - i2 - (g + k) i1) h, bp = i1 + g hp, lp = i2 + g bp, where p = x - i2 and s1 =
/// c k i1 / 2.
///
/// No coefficient is a difference, and each takes part in the response by its own relative rounding: single precision keeps a low
/// centre as well as a high one.
#[portable]
pub fn trapezoidal<R: Real>(part: &mut Trapezoidal<R>, shape: &Shape<R>) {
    let g = shape.g;
    let k = shape.k;
    let ck = shape.c * k;
    let d = R::ONE + k * g + g * g;
    part.a = ck * g / d;
    part.b = R::lit(2.0) * (g + k) * g / d;
    part.c = R::lit(2.0) * g / ck;
}

/// The denominator, by the bilinear transform s = (1 - z^-1) / (1 + z^-1) of s^2 + k g s + g^2.
///
/// At a low centre a1 is near -2 and a2 near 1, and what counts is their distance from there: 1 + a1 + a2 = 4 g^2 / d
/// places the centre. The distances are therefore computed without a cancellation and subtracted once, so that both
/// coefficients are within 0.6 units in the last place; by the formulas of the fields a1 is off by up to 2.5.
#[portable]
pub fn denominator<R: Real>(of: &mut Denominator<R>, shape: &Shape<R>) {
    let kg = shape.k * shape.g;
    let gg = shape.g * shape.g;
    let d = R::ONE + kg + gg;
    of.a1 = if gg < R::ONE {
        (R::lit(2.0) * kg + R::lit(4.0) * gg) / d - R::lit(2.0)
    } else {
        R::lit(2.0) * (gg - R::ONE) / d
    };
    of.a2 = R::ONE - R::lit(2.0) * kg / d;
    of.d = d;
}
