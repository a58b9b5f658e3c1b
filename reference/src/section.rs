//! Common parts of all second-order sections: their state, their form, the constants that keep them out of the subnormal range.

use crate::check_word::largest_number;
use crate::precision::is_single;
use portable::{Real, in_range, portable};

/// State of a second-order section: s1 and s2 of a biquad; in single precision s1 and p, or s1 and low.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// filter state s1: part of the next output
    pub s1: R,
    /// filter state s2: part of the next s1
    pub s2: R,
    /// filter state p: the input minus its low-pass part
    pub p: R,
    /// filter state low: the low-pass part of the input
    pub low: R,
}

/// Whether sections are trapezoidal and driven by the change of their input: in single precision. In double precision they are
/// biquads.
///
/// The speed of the axis is up to 500 times the vibration. The states of a biquad contain the speed, so their rounding errors
/// are relative to the speed. The change of the input does not contain it.
#[portable]
pub fn is_driven_by_change<R: Real>() -> bool {
    is_single::<R>()
}

constants! {
    /// added in every update of s2, so that a section at rest never decays into subnormal numbers
    ///
    /// On a PLC's x86 an operation on a subnormal can take a hundred times as long as on a normal number. The value is far
    /// below any velocity: 1e-30 in double, 1e-18 in single precision.
    pub fn anti_denormal<R: Real>() -> R { R::per_kind(1.0e-30, 1.0e-18) }
    /// added to every change of an input and to the filter state low, so that a section at rest never decays into subnormal
    /// numbers
    ///
    /// One addition to a change serves all sections that it drives.
    pub fn least_change<R: Real>() -> R { R::lit(1.0e-18) }
    /// 2: upper bound of |a1| of a stable biquad, and of B of a stable trapezoidal section
    pub fn pole_limit<R: Real>() -> R { R::lit(2.0) }
}

/// Whether the poles of a biquad lie inside the unit circle: |a2| < 1 and |a1| < 1 + a2. False for a NaN.
#[portable]
pub fn is_stable_biquad<R: Real>(a1: R, a2: R) -> bool {
    let mut is_stable = false;
    if in_range(a1, pole_limit()) && in_range(a2, R::ONE) {
        let edge = a2 + R::ONE;
        is_stable = a2 < R::ONE && a1 < edge && -edge < a1;
    }
    is_stable
}

/// Whether the poles of a trapezoidal section lie inside the unit circle: 0 < A C < B < 2. False for a NaN.
#[portable]
pub fn is_stable_trapezoidal<R: Real>(a: R, b: R, c: R) -> bool {
    let mut is_stable = false;
    if in_range(a, largest_number()) && in_range(b, pole_limit()) && in_range(c, largest_number()) {
        is_stable = are_poles_inside(a, b, c);
    }
    is_stable
}

/// Whether 0 < A C < B < 2, for arguments that are numbers.
#[portable]
pub fn are_poles_inside<R: Real>(a: R, b: R, c: R) -> bool {
    let product = a * c;
    R::ZERO < product && product < b && b < pole_limit()
}
