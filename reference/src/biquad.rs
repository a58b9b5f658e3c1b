//! A general second-order section; it simulates the oscillation of the INDIRECT and SET_POINT modes.
//!
//! H(z) = (b0 + b1 z^-1 + b2 z^-2) / (1 + a1 z^-1 + a2 z^-2), transposed direct form II:
//!
//! ```text
//! y  = b0 x + s1
//! s1 = b1 x - a1 y + s2
//! s2 = b2 x - a2 y
//! ```

use crate::section::{State, anti_denormal};
use portable::{Real, portable};

/// Coefficients, with a0 = 1 and the signs of `y = b0 x + s1; s1 = b1 x - a1 y + s2; s2 = b2 x - a2 y`.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// numerator: y = b0 x + s1
    pub b0: R,
    /// numerator: s1 = b1 x - a1 y + s2
    pub b1: R,
    /// numerator: s2 = b2 x - a2 y
    pub b2: R,
    /// denominator: s1 = b1 x - a1 y + s2
    pub a1: R,
    /// denominator: s2 = b2 x - a2 y
    pub a2: R,
    /// 1 - b0: steady s1 for a constant input of 1
    pub preset_s1: R,
    /// b2 - a2: steady s2 for a constant input of 1
    pub preset_s2: R,
}

/// One cycle: takes the input, gives the output.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    let y = coeffs.b0 * x + state.s1;
    state.s1 = coeffs.b1 * x - coeffs.a1 * y + state.s2;
    state.s2 = coeffs.b2 * x + anti_denormal() - coeffs.a2 * y;
    y
}

/// Puts the state where a constant input `x` would have brought it; gives the output that belongs to it. Gain at DC: 1.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    state.s1 = coeffs.preset_s1 * x;
    state.s2 = coeffs.preset_s2 * x;
    x
}
