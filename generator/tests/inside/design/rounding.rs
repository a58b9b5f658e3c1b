//! How far a response may be off because coefficients are numbers of 53 bits. No design.

use crate::inside::sets::Set;
use portable::Extreme;
use reference::bandpass;

/// Half a unit in the last place of a number in 1..2.
const HALF_ULP: f64 = f64::EPSILON / 2.0;

/// Largest relative error of a section's response at t = tan(pi f Ts) that the rounding of a1 and a2 can cause.
///
/// (1 + j t)^2 times the denominator is D = (1 + a1 + a2) + 2 (1 - a2) j t - (1 - a1 + a2) t^2. An error of a1 and a2 moves D
/// by at most (da1 + da2) (1 + t^2) + 2 da2 t. At a low centre |D| itself is small: that is the whole trouble, and why
/// the error grows as 1/(f0 Ts)^2. a1 is within half a unit (of a number in 1..2) plus the roundings of the difference
/// from 2 that it is computed from, which are relative to that difference; a2 likewise, half as large and from 1.
pub fn of_section(a1: f64, a2: f64, t: f64) -> f64 {
    let da1 = HALF_ULP * (1.0 + 3.0 * (2.0 - a1.abs()));
    let da2 = HALF_ULP * (0.5 + 3.0 * (1.0 - a2));
    let real = ((1.0 + a1) + a2) - ((1.0 - a1) + a2) * t * t;
    let imaginary = 2.0 * (1.0 - a2) * t;
    ((da1 + da2) * (1.0 + t * t) + 2.0 * da2 * t) / libm::hypot(real, imaginary)
}

/// The same for a cascade, with the roundings of everything else: of Omega0 and B (amplified by a quality factor of up
/// to 20), of b0, and of the evaluation.
pub fn of_sections(sections: &[bandpass::Coeffs<f64>], t: f64) -> f64 {
    sections.iter().map(|s| of_section(s.a1, s.a2, t) + 60.0 * HALF_ULP).sum()
}

/// What is demanded of the whole product against an independent implementation, relative to the peak of the response:
/// 1e-9 down to f0 Ts = 6e-4, then growing as 1/(f0 Ts)^2: 1e-7 at 6e-5, 1e-5 at 6e-6.
pub fn demanded(set: &Set) -> f64 {
    let below = (6e-4 / set.product).larger(1.0);
    1e-9 * below * below
}
