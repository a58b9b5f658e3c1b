//! What an output may be, given the exact value: an interval that rounding explains, and a point wherever it can. No formula
//! of a block is here.

use super::exact::Exact;

/// From, to.
pub type Interval = [f64; 2];

/// Each output by its name; integers and flags as numbers.
pub type Expected = Vec<(&'static str, Interval)>;

/// A real output.
#[must_use]
pub fn real(value: &Exact, u: f64) -> Interval {
    value.range(u)
}

/// A flag.
#[must_use]
pub fn flag(value: bool) -> Interval {
    [f64::from(u8::from(value)); 2]
}

/// An error id.
#[must_use]
pub fn id(value: u32) -> Interval {
    [f64::from(value); 2]
}

/// Process data, and whether they are limited.
#[derive(Clone, Copy, Debug)]
pub struct Data {
    /// the integer
    pub value: Interval,
    /// 0, 1
    pub limited: Interval,
}

/// Rounded half away from zero, saturated to a signed integer of so many bits.
#[must_use]
pub fn data(value: &Exact, u: f64, bits: u32) -> Data {
    let end = 2f64.powi(i32::try_from(bits).expect("16 or 32") - 1);
    let rounded = value.range(u).map(f64::round);
    let is_beyond = rounded.map(|number| !(-end..end).contains(&number));
    Data { value: rounded.map(|number| number.clamp(-end, end - 1.0)), limited: flags(is_beyond) }
}

/// A flag that two ends of an interval may have.
#[must_use]
pub fn flags([a, b]: [bool; 2]) -> Interval {
    [f64::from(u8::from(a && b)), f64::from(u8::from(a || b))]
}

/// True where one of two flags is.
#[must_use]
pub fn either(a: Interval, b: Interval) -> Interval {
    [a[0].max(b[0]), a[1].max(b[1])]
}
