//! From a real number to the integer that goes to the drive: rounded half away from zero, and saturated.

use portable::{Real, from_i32, portable, truncate};

/// The range of a process-data type.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// smallest value of the process data
    pub lowest: i32,
    /// largest value of the process data
    pub highest: i32,
    /// the same as a real number
    pub lower_limit: R,
    /// the same as a real number
    pub upper_limit: R,
}

/// from here on a fraction is rounded away from zero
#[portable]
pub fn half<R: Real>() -> R {
    R::lit(0.5)
}

/// The nearest integer, the one away from zero where two are as near; within the range.
#[portable]
pub fn rounded<R: Real>(coeffs: &Coeffs<R>, x: R) -> i32 {
    let mut value = coeffs.highest;
    if x <= coeffs.lower_limit {
        value = coeffs.lowest;
    } else if x < coeffs.upper_limit {
        let whole = truncate(x);
        // Exact: what a truncated number lacks is a part of its own digits.
        let rest = x - from_i32::<R>(whole);
        value = whole;
        if rest >= half() {
            value += 1i32;
        } else if rest <= -half::<R>() {
            value -= 1i32;
        }
    }
    value
}

/// Whether the range cuts a number off.
#[portable]
pub fn is_limited<R: Real>(coeffs: &Coeffs<R>, x: R) -> bool {
    x < coeffs.lower_limit || x > coeffs.upper_limit
}
