//! Intervals of reals, with infinities and NaN. Rounding to nearest preserves the order of numbers, so the bounds of a result
//! are computed from the bounds of the operands, in the block's own real type.

#![expect(clippy::float_cmp, reason = "bounds are exact, and infinities are asked for")]

use portable::Extreme;
use portable::{Binary, RealKind};

/// The reals from `low` to `high`, in the block's own type; a bound may be infinite; empty if `low > high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    pub low: f64,
    pub high: f64,
    /// whether it may be NaN
    pub nan: bool,
}

impl Interval {
    /// Any bit pattern.
    pub const ANY: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY, nan: true };
    /// No value.
    pub const NONE: Self = Self { low: f64::INFINITY, high: f64::NEG_INFINITY, nan: false };

    pub(super) fn one(value: f64) -> Self {
        if value.is_nan() { Self { nan: true, ..Self::NONE } } else { Self { low: value, high: value, nan: false } }
    }

    pub(super) fn numbers(low: f64, high: f64) -> Self {
        Self { low, high, nan: false }
    }

    /// Every finite number.
    pub(super) fn finite(kind: RealKind) -> Self {
        let largest = match kind {
            RealKind::F64 => f64::MAX,
            RealKind::F32 => f32::MAX.into(),
        };
        Self::numbers(-largest, largest)
    }

    pub fn has_number(self) -> bool {
        self.low <= self.high
    }

    pub(super) fn is_none(self) -> bool {
        !self.has_number() && !self.nan
    }

    /// Whether it is always a number, and never an infinity.
    pub fn is_finite(self) -> bool {
        !self.nan && self.low.is_finite() && self.high.is_finite()
    }

    /// The largest magnitude of a number.
    pub fn magnitude(self) -> f64 {
        if self.has_number() { self.low.abs().larger(self.high.abs()) } else { 0.0 }
    }

    pub(super) fn join(self, other: Self) -> Self {
        Self { low: self.low.smaller(other.low), high: self.high.larger(other.high), nan: self.nan || other.nan }
    }

    pub(super) fn meet(self, other: Self) -> Self {
        let met =
            Self { low: self.low.larger(other.low), high: self.high.smaller(other.high), nan: self.nan && other.nan };
        if met.has_number() { met } else { Self { nan: met.nan, ..Self::NONE } }
    }

    pub(super) fn negated(self) -> Self {
        Self { low: -self.high, high: -self.low, nan: self.nan }
    }

    /// The numbers that are rounded into the interval. Some machines also round a subnormal number to 0.
    pub(super) fn before_rounding(self, kind: RealKind) -> Self {
        let least = least_normal(kind);
        let up_from = |bound: f64| if bound.abs() <= least { least } else { above(bound, kind) };
        Self { low: -up_from(-self.low), high: up_from(self.high), nan: self.nan }
    }

    fn has_infinity(self) -> bool {
        self.has_number() && (self.low == f64::NEG_INFINITY || self.high == f64::INFINITY)
    }

    fn has_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }
}

/// The result of an operator on two reals of that type.
pub(super) fn binary(operator: Binary, a: Interval, b: Interval, kind: RealKind) -> Interval {
    let nan = a.nan || b.nan;
    if !a.has_number() || !b.has_number() {
        return Interval { nan, ..Interval::NONE };
    }
    let b = if operator == Binary::Subtract { b.negated() } else { b };
    let result = match operator {
        Binary::Add | Binary::Subtract => sum(a, b, kind),
        Binary::Multiply => product(a, b, kind),
        Binary::Divide => quotient(a, b, kind),
        _ => panic!("ranges: {operator:?} of two reals gives no real"),
    };
    // Some machines treat subnormal numbers as 0.
    let least = least_normal(kind);
    Interval {
        low: if result.low > 0.0 && result.low < least { 0.0 } else { result.low },
        high: if result.high < 0.0 && result.high > -least { 0.0 } else { result.high },
        nan: nan || result.nan,
    }
}

fn sum(a: Interval, b: Interval, kind: RealKind) -> Interval {
    let [up, down] = [f64::INFINITY, f64::NEG_INFINITY];
    let nan = a.high == up && b.low == down || a.low == down && b.high == up;
    let low = if a.low == down || b.low == down { down } else { rounded(Binary::Add, a.low, b.low, kind) };
    let high = if a.high == up || b.high == up { up } else { rounded(Binary::Add, a.high, b.high, kind) };
    Interval { low, high, nan }
}

fn product(a: Interval, b: Interval, kind: RealKind) -> Interval {
    let nan = a.has_zero() && b.has_infinity() || a.has_infinity() && b.has_zero();
    // An infinite bound also represents large numbers: their product with 0 is 0.
    let of = |x: f64, y: f64| if x == 0.0 || y == 0.0 { 0.0 } else { rounded(Binary::Multiply, x, y, kind) };
    Interval { nan, ..of_corners(a, b, of) }
}

fn quotient(a: Interval, b: Interval, kind: RealKind) -> Interval {
    let nan = a.has_zero() && b.has_zero() || a.has_infinity() && b.has_infinity();
    if b.has_zero() || a.has_infinity() && b.has_infinity() {
        return Interval { nan, ..Interval::ANY };
    }
    Interval { nan, ..of_corners(a, b, |x, y| rounded(Binary::Divide, x, y, kind)) }
}

/// The numbers between the results of an operation on the bounds.
fn of_corners(a: Interval, b: Interval, of: impl Fn(f64, f64) -> f64) -> Interval {
    let all = [of(a.low, b.low), of(a.low, b.high), of(a.high, b.low), of(a.high, b.high)];
    let (low, high) =
        all.iter().fold((all[0], all[0]), |(low, high), value| (low.smaller(*value), high.larger(*value)));
    Interval { low, high, nan: false }
}

/// An operation on two numbers, rounded as the block rounds it.
pub(super) fn rounded(operator: Binary, a: f64, b: f64, kind: RealKind) -> f64 {
    fn of<R: portable::Real>(operator: Binary, a: f64, b: f64) -> f64 {
        let (a, b) = (R::lit(a), R::lit(b));
        match operator {
            Binary::Add => a + b,
            Binary::Multiply => a * b,
            Binary::Divide => a / b,
            _ => a - b,
        }
        .to_f64()
    }
    match kind {
        RealKind::F64 => of::<f64>(operator, a, b),
        RealKind::F32 => of::<f32>(operator, a, b),
    }
}

/// The smallest positive number that is not subnormal.
fn least_normal(kind: RealKind) -> f64 {
    match kind {
        RealKind::F64 => f64::MIN_POSITIVE,
        RealKind::F32 => f32::MIN_POSITIVE.into(),
    }
}

/// The next number above, in that type.
pub(super) fn above(value: f64, kind: RealKind) -> f64 {
    match kind {
        RealKind::F64 => value.next_up(),
        RealKind::F32 => <f32 as portable::Real>::lit(value).next_up().into(),
    }
}
