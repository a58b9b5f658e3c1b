//! An all-pass, always of second order.

use super::band::Band;
use super::denominator::denominator;
use portable::Real;

/// Coefficients, with a0 = 1 and the signs of `y = a2 x + s1; s1 = a1 x - a1 y; s2 = x - a2 y`.
///
/// H = (s^2 - B s + Omega0^2) / (s^2 + B s + Omega0^2) = 1 - 2 H_BP, H_BP the band-pass of order 1 in the same band: its
/// a1 and a2 are this all-pass's. |H| = 1 everywhere; the phase falls from 0 at DC over -90 degrees at the lower edge,
/// -180 degrees at the centre (P-AXIS-00751) and -270 degrees at the upper edge to -360 degrees at the Nyquist frequency.
/// All in f64, each rounded once to `R`.
#[must_use]
pub fn coefficients<R: Real>(band: &Band) -> reference::allpass::Coeffs<R> {
    let d = denominator(band.omega0, band.bandwidth / band.omega0);
    reference::allpass::Coeffs { a1: R::lit(d.a1), a2: R::lit(d.a2), preset: R::lit(1.0 - d.a2) }
}
