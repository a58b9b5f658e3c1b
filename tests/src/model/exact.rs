//! An exact rational number, and next to it how far rounding may carry the same expression in floating point. No formula of a
//! block is here.
//!
//! The bound is the first-order running error bound (Higham, Accuracy and Stability of Numerical Algorithms, 3.3), in units of
//! the unit roundoff u: an input has 0, every operation adds the size of its result. The size of a sum is the sum of the
//! magnitudes of its terms, so that the order in which somebody adds them does not matter.

use dashu_ratio::Relaxed;

/// Factor on the bound, for coefficients that somebody computes by more or other roundings than the model's formula shows.
const SAFETY: f64 = 4.0;

/// An exact value, and what rounding may do to it.
#[derive(Clone, Debug)]
pub struct Exact {
    value: Relaxed,
    /// at least |value|
    size: f64,
    /// bound of the rounding error, in units of u
    roundings: f64,
}

impl Exact {
    /// 0.
    #[must_use]
    pub fn zero() -> Self {
        Self::given(0.0)
    }

    /// An input or a parameter, which is a number of the block's real type.
    ///
    /// # Panics
    /// If it is not a finite number.
    #[must_use]
    pub fn given(value: f64) -> Self {
        let exact = Relaxed::try_from(value).unwrap_or_else(|_| panic!("model: {value} is no number"));
        Self { value: exact, size: value.abs(), roundings: 0.0 }
    }

    /// A quotient of parameters, rounded once.
    #[must_use]
    pub fn ratio(num: u32, denom: u32) -> Self {
        let size = f64::from(num) / f64::from(denom);
        let value = Relaxed::from(num) / Relaxed::from(denom);
        Self { value, size, roundings: size }
    }

    /// A decimal fraction, rounded once: digits / 10^places.
    #[must_use]
    pub fn decimal(digits: u128, places: u32) -> Self {
        let value = Relaxed::from(digits) / Relaxed::from(10u128.pow(places));
        let size = value.to_f64_fast();
        Self { value, size, roundings: size }
    }

    /// self + other.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let size = self.size + other.size;
        Self { value: &self.value + &other.value, size, roundings: self.roundings + other.roundings + size }
    }

    /// self * other.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let size = self.size * other.size;
        let carried = self.roundings * other.size + self.size * other.roundings;
        Self { value: &self.value * &other.value, size, roundings: carried + size }
    }

    /// self / other; the divisor is not 0.
    #[must_use]
    pub fn over(&self, other: &Self) -> Self {
        let size = self.size / other.size;
        let carried = self.roundings / other.size + size * other.roundings / other.size;
        Self { value: &self.value / &other.value, size, roundings: carried + size }
    }

    /// a - b of two given numbers: one rounding, relative to the difference and not to the numbers.
    #[must_use]
    pub fn difference(a: f64, b: f64) -> Self {
        let size = (a - b).abs() * (1.0 + f64::EPSILON);
        let value = Self::given(a).value - Self::given(b).value;
        Self { value, size, roundings: size }
    }

    /// Whether it is exactly 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.value.is_zero()
    }

    /// The nearest double, or one next to it.
    #[must_use]
    pub fn near(&self) -> f64 {
        self.value.to_f64_fast()
    }

    /// The values that a computation with the unit roundoff u may have: from, to.
    #[must_use]
    pub fn range(&self, u: f64) -> [f64; 2] {
        let near = self.near();
        if self.roundings == 0.0 {
            return [near, near];
        }
        // the smallest number covers what underflows
        let off = SAFETY * self.roundings * u + near.abs() * f64::EPSILON + f64::from(f32::MIN_POSITIVE) * u;
        [near - off, near + off]
    }
}
