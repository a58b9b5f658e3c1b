//! Arithmetic with 31 digits: a number is the sum of two doubles that do not overlap. No filter.
//!
//! Every operation is built of error-free transformations (Dekker, Knuth): its relative error is a few units of 2^-104.

use std::f64::consts;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// high + low, |low| at most half a unit in the last place of high.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wide {
    high: f64,
    low: f64,
}

/// a + b = s + e, exactly.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

/// The same where |a| >= |b|.
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// Halves of 26 bits.
fn split(a: f64) -> (f64, f64) {
    let t = 134_217_729.0 * a; // 2^27 + 1
    let high = t - (t - a);
    (high, a - high)
}

/// a b = p + e, exactly.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

impl Wide {
    /// pi
    pub const PI: Self = Self { high: consts::PI, low: 1.224_646_799_147_353_2e-16 };

    /// The nearest double.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.high
    }

    /// By Newton's iteration from the square root in double precision.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let mut root = Self::from(self.high.sqrt());
        for _ in 0..2 {
            root = (root + self / root) * Self::from(0.5);
        }
        root
    }

    /// sin x / cos x of 0 <= x <= pi / 2 by their Taylor series at x / 1024, doubled ten times.
    #[must_use]
    pub fn tan(self) -> Self {
        let x = self * Self::from(1.0 / 1024.0);
        let square = x * x;
        let (mut sin, mut term) = (x, x);
        for n in 1..10 {
            term = -(term * square) / Self::from(f64::from(2 * n * (2 * n + 1)));
            sin = sin + term;
        }
        // 1 - cos, which is small: doubled it is 2 sin^2, without a cancellation.
        let mut versed = square * Self::from(0.5);
        term = versed;
        for n in 2..11 {
            term = -(term * square) / Self::from(f64::from((2 * n - 1) * 2 * n));
            versed = versed + term;
        }
        for _ in 0..10 {
            let cos = Self::from(1.0) - versed;
            (sin, versed) = (sin * cos * Self::from(2.0), sin * sin * Self::from(2.0));
        }
        sin / (Self::from(1.0) - versed)
    }
}

impl From<f64> for Wide {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Neg for Wide {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Add for Wide {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (s, e) = two_sum(self.high, other.high);
        let (t, f) = two_sum(self.low, other.low);
        let (s, e) = quick_two_sum(s, e + t);
        let (high, low) = quick_two_sum(s, e + f);
        Self { high, low }
    }
}

impl Sub for Wide {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (p, e) = two_product(self.high, other.high);
        let (high, low) = quick_two_sum(p, e + self.high * other.low + self.low * other.high);
        Self { high, low }
    }
}

impl Div for Wide {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::from(second);
        let (high, low) = quick_two_sum(first, second);
        Self { high, low } + Self::from(rest.high / other.high)
    }
}
