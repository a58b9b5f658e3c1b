//! Bounds of a second-order section without input, in closed form. No step is run.

use portable::Extreme;

/// A denominator 1 + a1 z^-1 + a2 z^-2, without a cancellation.
pub(super) struct Denominator {
    pub a1: f64,
    pub a2: f64,
    /// 1 - a2
    pub left: f64,
    /// 1 + a1 + a2
    pub dc: f64,
    /// 1 - a1 + a2
    pub nyquist: f64,
}

/// Bounds of one section.
pub(super) struct Free {
    /// a1 / 2: minus the mean of the poles
    pub half: f64,
    /// bound of sum |even(n)|, even(n) = (p1^n + p2^n) / 2: a time constant, in samples
    pub even: f64,
    /// bound of sum |odd(n)|, odd(n) = (p1^n - p2^n) / (p1 - p2)
    odd: f64,
    /// for a complex pair: distance of a pole from the real axis
    imaginary: Option<f64>,
}

/// Bounds of a section with the poles p1 and p2, the zeros of z^2 + a1 z + a2.
///
/// A complex pair r e^(+-j w): |even| <= r^n and |odd| <= r^(n-1) min(1 / sin w, n), hence sum |even| <= 1 / (1 - r),
/// sum |odd| <= min(1 / (r sin w (1 - r)), 1 / (1 - r)^2). Real poles: odd(n) = sum p1^k p2^(n-1-k), hence
/// sum |odd| <= 1 / ((1 - |p1|) (1 - |p2|)). Infinite where a pole is not inside the unit circle.
///
/// (p1 - p2)^2 / 4 = a1^2/4 - a2 = ((1 - a2)^2 - (1 + a1 + a2)(1 - a1 + a2)) / 4 is computed in the second form, which
/// does not cancel where both poles are near 1.
pub(super) fn bounds(of: &Denominator) -> Free {
    let Denominator { a1, a2, left: width, dc, nyquist } = *of;
    let half = a1 / 2.0;
    let square = (width * width - dc * nyquist) / 4.0;
    if !(a2.abs() < 1.0 && dc > 0.0 && nyquist > 0.0) {
        return Free { half, even: f64::INFINITY, odd: f64::INFINITY, imaginary: None };
    }
    if square < 0.0 {
        let r = libm::sqrt(a2);
        let left = width / (1.0 + r); // 1 - r
        let imaginary = libm::sqrt(-square);
        let odd = (1.0 / (imaginary * left)).smaller(1.0 / (left * left));
        return Free { half, even: 1.0 / left, odd, imaginary: Some(imaginary) };
    }
    let distance = libm::sqrt(square);
    let left = [1.0 - (distance - half).abs(), 1.0 - (distance + half).abs()];
    // Where the poles are real and near 1, the product is the value of the denominator there.
    Free { half, even: (1.0 / left[0] + 1.0 / left[1]) / 2.0, odd: 1.0 / (left[0] * left[1]), imaginary: None }
}

impl Free {
    /// Bound of the sum of all |y| = |s1| from a state on, the present one included:
    /// s1(n) = s1 even(n) + (s2 - a1/2 s1) odd(n).
    pub(super) fn sum(&self, s1: f64, s2: f64) -> f64 {
        let slope = s2 - self.half * s1;
        if s1 == 0.0 && slope == 0.0 {
            return 0.0;
        }
        let apart = s1.abs() * self.even + slope.abs() * self.odd;
        // One oscillation of this amplitude, which is a tighter bound than the sum of its two parts.
        self.imaginary.map_or(apart, |imaginary| apart.smaller(libm::hypot(s1, slope / imaginary) * self.even))
    }

    /// Bound of the sum of all |s1| from any state with |s1| and |s2| of at most 1; |a1| < 2.
    pub(super) fn sum_of_any(&self) -> f64 {
        self.even + 2.0 * self.odd
    }
}
