//! From centre and damping of a second-order section to the denominator that all sections share.

/// Denominator 1 + a1 z^-1 + a2 z^-2, and what a numerator must be divided by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Denominator {
    /// y = ... - a1 y(one cycle ago)
    pub a1: f64,
    /// y = ... - a2 y(two cycles ago)
    pub a2: f64,
    /// d = 1 + k g + g^2
    pub divisor: f64,
}

/// Bilinear transform s = (1 - z^-1) / (1 + z^-1) of s^2 + k g s + g^2, `g` the warped centre and `k` the reciprocal of
/// the section's quality factor.
///
/// a1 = 2 (g^2 - 1) / d, a2 = (1 - k g + g^2) / d, d = 1 + k g + g^2, with the signs of `y = x - a1 y' - a2 y''`.
///
/// At a low centre a1 is near -2 and a2 near 1, and what counts is their distance from there: 1 + a1 + a2 = 4 g^2 / d
/// places the centre. The distances are therefore computed without a cancellation and subtracted once, so that both
/// coefficients are within 0.6 units in the last place; by the formulas above a1 is off by up to 2.5.
#[must_use]
pub fn denominator(g: f64, k: f64) -> Denominator {
    let kg = k * g;
    let gg = g * g;
    let divisor = 1.0 + kg + gg;
    let a1 = if gg < 1.0 { (2.0 * kg + 4.0 * gg) / divisor - 2.0 } else { 2.0 * (gg - 1.0) / divisor };
    let a2 = 1.0 - 2.0 * kg / divisor;
    Denominator { a1, a2, divisor }
}

/// Value of c0 + c1 z^-1 + c2 z^-2 at DC (z = 1) and at the Nyquist frequency (z = -1).
///
/// For a denominator (c0 = 1) both are exact where they are small: the 1 is added to a1 first, because 1 + a2 would be
/// rounded. Their ratio is g^2, whatever the damping.
#[must_use]
pub(crate) fn at_dc_and_nyquist(c0: f64, c1: f64, c2: f64) -> [f64; 2] {
    [(c0 + c1) + c2, (c0 - c1) + c2]
}
