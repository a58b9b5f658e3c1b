//! A band-pass section: a biquad with b1 = 0 and b2 = -b0, and no operation spent on either.
//!
//! H(z) = b0 (1 - z^-2) / (1 + a1 z^-1 + a2 z^-2). Zeros at DC and at the Nyquist frequency.

use crate::section::{State, anti_denormal};
use portable::{Real, portable};

/// Coefficients, with a0 = 1, b0 = -b2 and the signs of `y = -b2 x + s1; s1 = s2 - a1 y; s2 = b2 x - a2 y`.
///
/// b2 stands here rather than b0 because its product is used as it is in `s2`, where a sign would cost an instruction.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// numerator, b0 = -b2: y = s1 - b2 x, s2 = b2 x - a2 y
    pub b2: R,
    /// denominator: s1 = s2 - a1 y
    pub a1: R,
    /// denominator: s2 = b2 x - a2 y
    pub a2: R,
}

/// One cycle: takes the input, gives the output.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    let t = coeffs.b2 * x;
    let y = state.s1 - t;
    state.s1 = state.s2 - coeffs.a1 * y;
    state.s2 = t + anti_denormal() - coeffs.a2 * y;
    y
}

/// Puts the state where a constant input `x` would have brought it; gives the output that belongs to it: 0.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    let s = coeffs.b2 * x;
    state.s1 = s;
    state.s2 = s;
    R::ZERO
}
