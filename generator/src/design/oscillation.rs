//! The simulated oscillation of the INDIRECT and SET_POINT modes.

use super::denominator::denominator;
use portable::Real;

/// Coefficients, with a0 = 1 and the signs of `y = b0 x + s1; s1 = b1 x - a1 y + s2; s2 = b2 x - a2 y`.
///
/// The velocity of a load behind a visco-elastic coupling: H(s) = (k g s + g^2) / (s^2 + k g s + g^2), k = 2 D, with the
/// damping ratio D (P-AXIS-00850) and s = (1 - z^-1) / (1 + z^-1) prewarped at f0 by g = tan(pi f0 Ts) = `omega0`:
///
/// b0 = (k g + g^2) / d, b1 = 2 g^2 / d, b2 = (g^2 - k g) / d; a1, a2 and d as [`denominator`] has them.
///
/// H(f0) = 1 + 1 / (2 j D), gain 1 at DC. Lower damping, larger simulated vibration. The vendor documents state this
/// behaviour and no equation: that the coupling is visco-elastic is an inference from it.
/// All in f64, each rounded once to `R`.
#[must_use]
pub fn coefficients<R: Real>(omega0: f64, osc_damping: f64) -> reference::biquad::Coeffs<R> {
    let k = 2.0 * osc_damping;
    let d = denominator(omega0, k);
    let b0 = (omega0 + k) * omega0 / d.divisor;
    let b1 = 2.0 * omega0 * omega0 / d.divisor;
    let b2 = (omega0 - k) * omega0 / d.divisor;
    reference::biquad::Coeffs {
        b0: R::lit(b0),
        b1: R::lit(b1),
        b2: R::lit(b2),
        a1: R::lit(d.a1),
        a2: R::lit(d.a2),
        preset_s1: R::lit(1.0 - b0),
        preset_s2: R::lit(b2 - d.a2),
    }
}
