//! The check sums of a parameter set: what a block recomputes before it takes a set over. They read no bits, so that every language
//! can form them, and find each change of a number but the sign of a 0.
//!
//! ```text
//! high + middle + low   the sum of all numbers, in three parts: what the rounding of one part leaves goes into the next
//! weighted              the sum of each number times its place: numbers that have changed places
//! ```
//! What rounding leaves of a sum is exact (Knuth, The Art of Computer Programming 2, 4.2.2, theorem B).

use portable::{Real, in_range, portable};

/// The sums of the numbers so far.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums<R> {
    /// check sum: of all numbers, rounded
    pub high: R,
    /// check sum: what the rounding of high has left, rounded
    pub middle: R,
    /// check sum: what the rounding of middle has left
    pub low: R,
    /// check sum: of all numbers, each times its place
    pub weighted: R,
}

/// The place of the next number.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Place<R> {
    /// 1 for the first number
    pub now: R,
}

/// What the rounding of `a + b` = `total` leaves, exactly.
#[portable]
pub fn left<R: Real>(a: R, b: R, total: R) -> R {
    let part = total - a;
    let whole = total - part;
    let left_of_a = a - whole;
    let left_of_b = b - part;
    left_of_a + left_of_b
}

/// Adds a number, which is in range.
#[portable]
pub fn add<R: Real>(sums: &mut Sums<R>, place: &mut Place<R>, number: R) {
    let high = sums.high + number;
    let left_of_high = left(sums.high, number, high);
    let middle = sums.middle + left_of_high;
    let left_of_middle = left(sums.middle, left_of_high, middle);
    sums.high = high;
    sums.middle = middle;
    sums.low = sums.low + left_of_middle;
    place.now = place.now + R::ONE;
    sums.weighted = sums.weighted + place.now * number;
}

/// A limit is scaled, so that it does not hide what is small.
#[portable]
pub fn limit_scale<R: Real>() -> R {
    R::lit(0.000_015_258_789_062_5)
}

/// Whether both are the same numbers.
#[portable]
pub fn are_same<R: Real>(told: &Sums<R>, formed: &Sums<R>) -> bool {
    in_range(told.high - formed.high, R::ZERO)
        && in_range(told.middle - formed.middle, R::ZERO)
        && in_range(told.low - formed.low, R::ZERO)
        && in_range(told.weighted - formed.weighted, R::ZERO)
}
