//! The section that simulates the oscillation of the INDIRECT and SET_POINT modes. Double precision: a general biquad. Single
//! precision: the input minus its high-pass part, which is computed by the trapezoidal rule.
//!
//! H(z) = (b0 + b1 z^-1 + b2 z^-2) / (1 + a1 z^-1 + a2 z^-2), in double precision in transposed direct form II:
//!
//! ```text
//! y  = b0 x + s1
//! s1 = b1 x - a1 y + s2
//! s2 = b2 x - a2 y
//! ```
//!
//! in single precision, with the warped centre g, k = 2 D and h = 1 / (1 + (g + k) g):
//!
//! ```text
//! p  = p + change of x
//! q  = h p - 2 (g + k) h s1
//! bp = s1 + (s1 + g q)
//! s1 = s1 + g q
//! p  = p - 2 g bp
//! y  = x - q
//! ```

use crate::section::{State, anti_denormal, is_driven_by_change};
use crate::trapezoidal;
use crate::turn::{Picked, role_a2, role_g2};
use portable::{Real, copy, portable};

/// Coefficients, with a0 = 1 and the signs of `y = b0 x + s1; s1 = b1 x - a1 y + s2; s2 = b2 x - a2 y`.
///
/// Single precision uses h, r, g and g2, double precision the others.
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
    /// H = h: q = H p - R s1, y = x - q, p = x - low-pass part
    pub h: R,
    /// R = 2 (g + k) h: q = H p - R s1
    pub r: R,
    /// G = g, the warped centre: bp = s1 + (s1 + G q), s1 = s1 + G q
    pub g: R,
    /// G2 = 2 g: the low-pass part grows by G2 bp
    pub g2: R,
}

/// One cycle: takes the input and its change since the previous cycle, returns the output. Double precision does not use the
/// change.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R, change: R) -> R {
    if is_driven_by_change::<R>() { by_change(state, coeffs, x, change) } else { biquad(state, coeffs, x) }
}

/// One cycle driven by the change of the input.
#[portable]
pub fn by_change<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R, change: R) -> R {
    let left = state.p + change;
    let q = coeffs.h * left - coeffs.r * state.s1;
    let next = state.s1 + coeffs.g * q;
    let bp = state.s1 + next;
    state.s1 = next;
    state.p = left - coeffs.g2 * bp;
    x - q
}

/// One cycle of the biquad.
#[portable]
pub fn biquad<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    let y = coeffs.b0 * x + state.s1;
    state.s1 = coeffs.b1 * x - coeffs.a1 * y + state.s2;
    state.s2 = coeffs.b2 * x + anti_denormal() - coeffs.a2 * y;
    y
}

/// Sets the state to the steady state for a constant input `x`; returns the steady output. Gain at DC: 1.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    if is_driven_by_change::<R>() {
        trapezoidal::preset_by_change(state);
    } else {
        state.s1 = coeffs.preset_s1 * x;
        state.s2 = coeffs.preset_s2 * x;
    }
    x
}

numbers! {
    single: h 0u32, r 1u32, g 2u32, g2 3u32 role_g2;
    double: b0 0u32, b1 1u32, b2 2u32, a1 3u32, a2 4u32 role_a2, preset_s1 5u32, preset_s2 6u32;
    turns: 4u32, 7u32
}
