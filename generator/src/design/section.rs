//! Second-order sections: from centre and damping to coefficients. No filter, no pole.
//!
//! As biquads, for double precision, all of them have the denominator of [`denominator`]; a0 = 1. `preset` is the state for
//! a constant input of 1. For single precision they have the coefficients of [`trapezoidal`].

use reference::{allpass, bandpass, oscillation};

/// A section before the transform s = (1 - z^-1) / (1 + z^-1).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shape {
    /// centre on the warped frequency axis: tan(pi f Ts)
    pub g: f64,
    /// reciprocal of the section's quality factor
    pub k: f64,
    /// gain at the section's own centre
    pub c: f64,
}

/// A band-pass c k g s / (s^2 + k g s + g^2), with the signs of `y = -b2 x + s1; s1 = s2 - a1 y; s2 = b2 x - a2 y`.
///
/// b0 = c k g / d, b1 = 0, b2 = -b0, which alone is kept.
pub(crate) fn bandpass(of: &Shape) -> bandpass::Coeffs<f64> {
    let ([a1, a2], d) = denominator(of);
    let [a, b, c] = trapezoidal(of);
    bandpass::Coeffs { b2: -(of.c * of.k * of.g / d), a1, a2, a, b, c }
}

/// An all-pass, with the signs of `y = a2 x + s1; s1 = a1 x - a1 y; s2 = x - a2 y`. At the centre Omega0 and the bandwidth B its
/// g is Omega0, and its k is B / Omega0.
///
/// H = (s^2 - B s + Omega0^2) / (s^2 + B s + Omega0^2) = 1 - 2 H_BP, H_BP the band-pass of order 1 in the same band: its
/// a1 and a2 are this all-pass's. |H| = 1 everywhere; the phase falls from 0 at DC over -90 degrees at the lower edge,
/// -180 degrees at the centre (P-AXIS-00751) and -270 degrees at the upper edge to -360 degrees at the Nyquist frequency.
pub(crate) fn allpass(of: &Shape) -> allpass::Coeffs<f64> {
    let ([a1, a2], _) = denominator(of);
    let [a, b, c] = trapezoidal(of);
    allpass::Coeffs { a1, a2, preset: 1.0 - a2, a, b, c }
}

/// The simulated oscillation of the INDIRECT and SET_POINT modes, with the signs of
/// `y = b0 x + s1; s1 = b1 x - a1 y + s2; s2 = b2 x - a2 y`.
///
/// The velocity of a load after a visco-elastic coupling: H(s) = (k g s + g^2) / (s^2 + k g s + g^2), k = 2 D, with the
/// damping ratio D (P-AXIS-00850) and s = (1 - z^-1) / (1 + z^-1) prewarped at f0 by g = tan(pi f0 Ts):
///
/// b0 = (k g + g^2) / d, b1 = 2 g^2 / d, b2 = (g^2 - k g) / d.
///
/// H(f0) = 1 + 1 / (2 j D), gain 1 at DC. Lower damping, larger simulated vibration. The vendor documents state this
/// behaviour and no equation: that the coupling is visco-elastic is an inference from it.
pub(crate) fn oscillation(of: &Shape) -> oscillation::Coeffs<f64> {
    let Shape { g, k, .. } = *of;
    let ([a1, a2], d) = denominator(of);
    let (b0, b1, b2) = ((g + k) * g / d, 2.0 * g * g / d, (g - k) * g / d);
    let (h, r) = (1.0 / d, 2.0 * (g + k) / d);
    oscillation::Coeffs { b0, b1, b2, a1, a2, preset_s1: 1.0 - b0, preset_s2: b2 - a2, h, r, g, g2: 2.0 * g }
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
pub(crate) fn trapezoidal(of: &Shape) -> [f64; 3] {
    let Shape { g, k, c } = *of;
    let d = 1.0 + k * g + g * g;
    [c * k * g / d, 2.0 * (g + k) * g / d, 2.0 * g / (c * k)]
}

/// Denominator 1 + a1 z^-1 + a2 z^-2, with the signs of `y = x - a1 y' - a2 y''`; and d, which a numerator must be divided by.
///
/// Bilinear transform s = (1 - z^-1) / (1 + z^-1) of s^2 + k g s + g^2:
///
/// a1 = 2 (g^2 - 1) / d, a2 = (1 - k g + g^2) / d, d = 1 + k g + g^2.
///
/// At a low centre a1 is near -2 and a2 near 1, and what counts is their distance from there: 1 + a1 + a2 = 4 g^2 / d
/// places the centre. The distances are therefore computed without a cancellation and subtracted once, so that both
/// coefficients are within 0.6 units in the last place; by the formulas above a1 is off by up to 2.5.
fn denominator(of: &Shape) -> ([f64; 2], f64) {
    let (kg, gg) = (of.k * of.g, of.g * of.g);
    let d = 1.0 + kg + gg;
    let a1 = if gg < 1.0 { (2.0 * kg + 4.0 * gg) / d - 2.0 } else { 2.0 * (gg - 1.0) / d };
    ([a1, 1.0 - 2.0 * kg / d], d)
}

/// Value of c0 + c1 z^-1 + c2 z^-2 at DC (z = 1) and at the Nyquist frequency (z = -1).
///
/// For a denominator (c0 = 1) both are exact where they are small: the 1 is added to a1 first, because 1 + a2 would be
/// rounded. Their ratio is g^2 for any damping.
pub(crate) fn at_dc_and_nyquist(c0: f64, c1: f64, c2: f64) -> [f64; 2] {
    [(c0 + c1) + c2, (c0 - c1) + c2]
}
