//! The larger and the smaller of two reals, to the last bit: for 0 and -0 the result of `f64::max` depends on the compiler.

/// Extremes of real numbers. A NaN loses against any number, and 0 is larger than -0.
pub trait Extreme {
    /// The larger of the two.
    #[must_use]
    fn larger(self, other: Self) -> Self;
    /// The smaller of the two.
    #[must_use]
    fn smaller(self, other: Self) -> Self;
}

impl Extreme for f64 {
    fn larger(self, other: Self) -> Self {
        let is_first = self > other || other.is_nan() || self >= other && self.is_sign_positive();
        if is_first { self } else { other }
    }

    fn smaller(self, other: Self) -> Self {
        let is_first = self < other || other.is_nan() || self <= other && self.is_sign_negative();
        if is_first { self } else { other }
    }
}

/// The largest magnitude of the samples; 0 if there are none or all are NaN.
#[must_use]
pub fn peak(samples: &[f64]) -> f64 {
    samples.iter().fold(0.0, |peak, sample| sample.abs().larger(peak))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_have_a_sign_and_a_nan_loses() {
        let bits = |pairs: [[f64; 2]; 6], of: fn(f64, f64) -> f64| pairs.map(|[a, b]| of(a, b).to_bits());
        let pairs = [[0.0, -0.0], [-0.0, 0.0], [1.0, -2.0], [-2.0, 1.0], [f64::NAN, 3.0], [3.0, f64::NAN]];
        assert_eq!(bits(pairs, f64::larger), [0.0, 0.0, 1.0, 1.0, 3.0, 3.0].map(f64::to_bits));
        assert_eq!(bits(pairs, f64::smaller), [-0.0, -0.0, -2.0, -2.0, 3.0, 3.0].map(f64::to_bits));
    }
}
