//! An all-pass section. Double precision: a biquad with b0 = a2, b1 = a1 and b2 = 1, without the multiplication by 1. Single
//! precision: the input minus twice its band-pass part, which is computed by the trapezoidal rule.
//!
//! H(z) = (a2 + a1 z^-1 + z^-2) / (1 + a1 z^-1 + a2 z^-2). Gain 1 everywhere; phase 0 at DC, -180 degrees at the centre
//! frequency, -360 degrees at the Nyquist frequency.

use crate::section::{State, anti_denormal, is_driven_by_change};
use crate::trapezoidal;
use crate::turn::{Picked, role_a2, role_c};
use portable::{Real, copy, portable};

/// Coefficients, with a0 = 1 and the signs of `y = a2 x + s1; s1 = a1 x - a1 y + s2; s2 = x - a2 y`.
///
/// Double precision uses a1, a2 and preset; single precision uses a, b and c.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// numerator and denominator: s1 = a1 x - a1 y + s2
    pub a1: R,
    /// numerator and denominator: y = a2 x + s1, s2 = x - a2 y
    pub a2: R,
    /// 1 - a2: steady s1 and s2 for a constant input of 1
    pub preset: R,
    /// A = g h k: u = A p - B s1, p = x - low-pass part
    pub a: R,
    /// B = 2 (g + k) g h: bp = s1 + (s1 + u), s1 = s1 + u, y = x - 2 bp
    pub b: R,
    /// C = 2 g / k: the low-pass part grows by C bp
    pub c: R,
}

/// One cycle: takes the input and its change since the previous cycle, returns the output. Double precision does not use the
/// change.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R, change: R) -> R {
    if is_driven_by_change::<R>() {
        let bp = trapezoidal::by_change(state, coeffs.a, coeffs.b, coeffs.c, change);
        x - (bp + bp)
    } else {
        biquad(state, coeffs, x)
    }
}

/// One cycle of the biquad.
#[portable]
pub fn biquad<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    let y = coeffs.a2 * x + state.s1;
    state.s1 = coeffs.a1 * (x - y) + state.s2;
    state.s2 = x + anti_denormal() - coeffs.a2 * y;
    y
}

/// Sets the state to the steady state for a constant input `x`; returns the steady output: `x`.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    if is_driven_by_change::<R>() {
        trapezoidal::preset_by_change(state);
    } else {
        let s = coeffs.preset * x;
        state.s1 = s;
        state.s2 = s;
    }
    x
}

numbers! {
    single: a 0u32, b 1u32, c 2u32 role_c;
    double: a1 0u32, a2 1u32 role_a2, preset 2u32;
    turns: 3u32, 3u32
}
