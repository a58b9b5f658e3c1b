//! From a real number to the integer that goes to the drive: rounded half away from zero, and saturated.

use portable::{Real, nearest, note, portable, within};

/// The range of a process-data type.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// smallest value of the process data
    pub lowest: i32,
    /// largest value of the process data
    pub highest: i32,
    /// smallest number that is rounded to the smallest value
    pub lower_limit: R,
    /// largest number that is rounded to the largest value
    pub upper_limit: R,
}

/// A rounded number.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Datum {
    /// the integer
    pub value: i32,
    /// whether the number is limited to the range
    pub limited: bool,
}

/// Rounds a number and limits it to the range.
#[portable]
pub fn round<R: Real>(datum: &mut Datum, coeffs: &Coeffs<R>, x: R) {
    datum.limited = false;
    if within(x, coeffs.upper_limit) {
        datum.value = nearest(x);
    } else if x > R::ZERO {
        datum.value = coeffs.highest;
        datum.limited = true;
    } else if x < R::ZERO {
        // Numbers between -highest - 1/2 and lowest - 1/2 are rounded to lowest = -highest - 1.
        datum.value = coeffs.lowest;
        datum.limited = x < coeffs.lower_limit;
    } else {
        note("reached only by NaN, which samples in range never produce: the output is 0");
        datum.value = 0i32;
        datum.limited = true;
    }
}
