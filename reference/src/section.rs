//! What all second-order sections share: their state, which form they have, the constants that keep them out of the subnormal range.

use crate::check_word::largest_number;
use crate::precision::is_single;
use portable::{Real, in_range, portable};

/// State of a second-order section: s1 and s2 of a biquad; in single precision s1 and p, or s1 and low.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// what the next output takes over
    pub s1: R,
    /// what `s1` takes over
    pub s2: R,
    /// the input without its low-pass part
    pub p: R,
    /// the low-pass part of the input
    pub low: R,
}

/// Whether sections are trapezoidal and driven by the change of their input: in single precision. In double precision they are
/// biquads.
///
/// The speed of the axis is up to 500 times the vibration. The states of a biquad carry it, so that their roundings are a part of
/// the speed. A change carries nothing of it.
#[portable]
pub fn is_driven_by_change<R: Real>() -> bool {
    is_single::<R>()
}

/// added in every update of s2, so that a section at rest never decays into subnormal numbers
///
/// On a PLC's x86 an operation on a subnormal can take a hundred times as long as on a normal number. The value is far
/// below any velocity: 1e-30 in double, 1e-18 in single precision.
#[portable]
pub fn anti_denormal<R: Real>() -> R {
    R::per_kind(1.0e-30, 1.0e-18)
}

/// added to every change and to low, so that a section at rest never decays into subnormal numbers
///
/// One addition to a change serves all sections that it drives.
#[portable]
pub fn least_change<R: Real>() -> R {
    R::lit(1.0e-18)
}

/// 2: |a1| of a stable biquad and B of a stable trapezoidal section are below it
#[portable]
pub fn pole_limit<R: Real>() -> R {
    R::lit(2.0)
}

/// Whether the poles of a biquad lie inside the unit circle: |a2| < 1 and |a1| < 1 + a2. False of what is no number.
#[portable]
pub fn is_stable_biquad<R: Real>(a1: R, a2: R) -> bool {
    let mut is_stable = false;
    if in_range(a1, pole_limit()) && in_range(a2, R::ONE) {
        let edge = a2 + R::ONE;
        is_stable = a2 < R::ONE && a1 < edge && -edge < a1;
    }
    is_stable
}

/// Whether those of a trapezoidal section do: 0 < A C < B < 2. False of what is no number.
#[portable]
pub fn is_stable_trapezoidal<R: Real>(a: R, b: R, c: R) -> bool {
    let mut is_stable = false;
    if in_range(a, largest_number()) && in_range(b, pole_limit()) && in_range(c, largest_number()) {
        is_stable = are_poles_inside(a, b, c);
    }
    is_stable
}

/// The same of numbers.
#[portable]
pub fn are_poles_inside<R: Real>(a: R, b: R, c: R) -> bool {
    let product = a * c;
    R::ZERO < product && product < b && b < pole_limit()
}
