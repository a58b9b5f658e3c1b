//! An all-pass section. Double precision: a biquad with b0 = a2, b1 = a1 and b2 = 1, without the multiplication by 1. Single
//! precision: the input minus twice its band-pass part, which is computed by the trapezoidal rule.
//!
//! H(z) = (a2 + a1 z^-1 + z^-2) / (1 + a1 z^-1 + a2 z^-2). Gain 1 everywhere; phase 0 at DC, -180 degrees at the centre
//! frequency, -360 degrees at the Nyquist frequency.

use crate::check_word::{Forming, add_three, largest_number};
use crate::section::{State, anti_denormal, is_driven_by_change, is_stable_biquad, is_stable_trapezoidal};
use crate::{trapezoidal, turn};
use portable::{Real, copy, in_range, portable, stored};

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

/// Copies the numbers of another section.
#[portable]
pub fn take<R: Real>(coeffs: &mut Coeffs<R>, offered: &Coeffs<R>) {
    if is_driven_by_change::<R>() {
        copy!(coeffs = offered: a, b, c);
    } else {
        copy!(coeffs = offered: a1, a2, preset);
    }
}

/// Compares the number whose turn it is with its copy; turns are numbered from `first`. Returns the turn after the last one.
#[portable]
pub fn compare<R: Real>(state: &mut turn::State, turn: i32, first: i32, now: &Coeffs<R>, copy: &Coeffs<R>) -> i32 {
    let mut at = first;
    if is_driven_by_change::<R>() {
        for i in 0..3 {
            if turn == at {
                let numbers = [stored(now.a), stored(now.b), stored(now.c)];
                let copies = [copy.a, copy.b, copy.c];
                let difference = numbers[i] - copies[i];
                state.next = if in_range(difference, R::ZERO) { at + 1i32 } else { turn::differed() };
            }
            at += 1i32;
        }
    } else {
        for i in 0..3 {
            if turn == at {
                let numbers = [stored(now.a1), stored(now.a2), stored(now.preset)];
                let copies = [copy.a1, copy.a2, copy.preset];
                let difference = numbers[i] - copies[i];
                state.next = if in_range(difference, R::ZERO) { at + 1i32 } else { turn::differed() };
            }
            at += 1i32;
        }
    }
    at
}

/// Whether every number is finite and the section is stable.
#[portable]
pub fn is_sound<R: Real>(coeffs: &Coeffs<R>) -> bool {
    if is_driven_by_change::<R>() {
        is_stable_trapezoidal(coeffs.a, coeffs.b, coeffs.c)
    } else {
        in_range(coeffs.preset, largest_number()) && is_stable_biquad(coeffs.a1, coeffs.a2)
    }
}

/// Adds the numbers to the check word.
#[portable]
pub fn add_up<R: Real>(forming: &mut Forming<R>, coeffs: &Coeffs<R>) {
    if is_driven_by_change::<R>() {
        let numbers = [coeffs.a, coeffs.b, coeffs.c];
        add_three(forming, &numbers);
    } else {
        let numbers = [coeffs.a1, coeffs.a2, coeffs.preset];
        add_three(forming, &numbers);
    }
}
