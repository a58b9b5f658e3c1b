//! An all-pass section: a biquad with b0 = a2, b1 = a1 and b2 = 1, and no operation spent on the 1.
//!
//! H(z) = (a2 + a1 z^-1 + z^-2) / (1 + a1 z^-1 + a2 z^-2). Gain 1 everywhere; phase 0 at DC, -180 degrees at the centre
//! frequency, -360 degrees at the Nyquist frequency.

use crate::section::{State, anti_denormal};
use portable::{Real, portable};

/// Coefficients, with a0 = 1 and the signs of `y = a2 x + s1; s1 = a1 x - a1 y + s2; s2 = x - a2 y`.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// numerator and denominator: s1 = a1 x - a1 y + s2
    pub a1: R,
    /// numerator and denominator: y = a2 x + s1, s2 = x - a2 y
    pub a2: R,
    /// 1 - a2: steady s1 and s2 for a constant input of 1
    pub preset: R,
}

/// One cycle: takes the input, gives the output.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    let y = coeffs.a2 * x + state.s1;
    state.s1 = coeffs.a1 * (x - y) + state.s2;
    state.s2 = x + anti_denormal() - coeffs.a2 * y;
    y
}

/// Puts the state where a constant input `x` would have brought it; gives the output that belongs to it: `x`.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    let s = coeffs.preset * x;
    state.s1 = s;
    state.s2 = s;
    x
}
