//! A band-pass section. Double precision: a biquad with b1 = 0 and b2 = -b0, without operations for these two. Single
//! precision: the trapezoidal rule.
//!
//! H(z) = b0 (1 - z^-2) / (1 + a1 z^-1 + a2 z^-2). Zeros at DC and at the Nyquist frequency.

use crate::section::{State, anti_denormal, is_driven_by_change};
use crate::trapezoidal;
use crate::turn::{Picked, role_a2, role_c};
use portable::{Real, copy, portable};

/// Coefficients, with a0 = 1, b0 = -b2 and the signs of `y = -b2 x + s1; s1 = s2 - a1 y; s2 = b2 x - a2 y`.
///
/// b2 is stored instead of b0 because `s2` uses its product directly; b0 would need an extra negation.
/// Double precision uses b2, a1 and a2; single precision uses a, b and c.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// numerator, b0 = -b2: y = s1 - b2 x, s2 = b2 x - a2 y
    pub b2: R,
    /// denominator: s1 = s2 - a1 y
    pub a1: R,
    /// denominator: s2 = b2 x - a2 y
    pub a2: R,
    /// A = g h c k: u = A p - B s1, p = x - low-pass part
    pub a: R,
    /// B = 2 (g + k) g h: u = A p - B s1, y = s1 + (s1 + u), s1 = s1 + u
    pub b: R,
    /// C = 2 g / (c k): the low-pass part grows by C y
    pub c: R,
}

/// One cycle: takes the input and its change since the previous cycle, returns the output. Double precision does not use the
/// change.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R, change: R) -> R {
    if is_driven_by_change::<R>() {
        trapezoidal::by_change(state, coeffs.a, coeffs.b, coeffs.c, change)
    } else {
        biquad(state, coeffs, x)
    }
}

/// One cycle after another band-pass section, which has removed the offset from the input.
#[portable]
pub fn step_behind<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    if is_driven_by_change::<R>() {
        trapezoidal::by_input(state, coeffs.a, coeffs.b, coeffs.c, x)
    } else {
        biquad(state, coeffs, x)
    }
}

/// One cycle of the biquad.
#[portable]
pub fn biquad<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    let t = coeffs.b2 * x;
    let y = state.s1 - t;
    state.s1 = state.s2 - coeffs.a1 * y;
    state.s2 = t + anti_denormal() - coeffs.a2 * y;
    y
}

/// Sets the state to the steady state for a constant input `x`; returns the steady output: 0.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    if is_driven_by_change::<R>() {
        trapezoidal::preset_by_change(state);
    } else {
        preset_biquad(state, coeffs, x);
    }
    R::ZERO
}

/// Sets the state to the steady state for a constant input `x` of a preceding band-pass section.
#[portable]
pub fn preset_behind<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    if is_driven_by_change::<R>() {
        trapezoidal::preset_by_input(state, x);
    } else {
        preset_biquad(state, coeffs, x);
    }
    R::ZERO
}

/// Sets the state of the biquad to its steady state.
#[portable]
pub fn preset_biquad<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) {
    let s = coeffs.b2 * x;
    state.s1 = s;
    state.s2 = s;
}

numbers! {
    single: a 0u32, b 1u32, c 2u32 role_c;
    double: b2 0u32, a1 1u32, a2 2u32 role_a2;
    turns: 3u32, 3u32
}
