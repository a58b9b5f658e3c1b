//! From a real number to the integer that goes to the drive: rounded half away from zero, and saturated.

use portable::{Real, nearest, portable, within};

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

/// What becomes of a number.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Datum {
    /// the integer
    pub value: i32,
    /// whether the range cuts the number off
    pub limited: bool,
}

/// Rounds a number; where it lies outside of the range the end of the range stands for it.
#[portable]
pub fn round<R: Real>(datum: &mut Datum, coeffs: &Coeffs<R>, x: R) {
    datum.limited = false;
    if within(x, coeffs.upper_limit) {
        datum.value = nearest(x);
    } else if x > R::ZERO {
        datum.value = coeffs.highest;
        datum.limited = true;
    } else if x > coeffs.lower_limit {
        // Between -highest and lowest, which is one less.
        datum.value = nearest(x);
    } else {
        datum.value = coeffs.lowest;
        datum.limited = x < coeffs.lower_limit;
    }
}
