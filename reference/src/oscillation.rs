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

#![expect(clippy::needless_range_loop, reason = "the portable subset has one way to go through an array")]

use crate::check_word::{Forming, add, largest_number};
use crate::section::{State, anti_denormal, are_poles_inside, is_driven_by_change, is_stable_biquad};
use crate::{trapezoidal, turn};
use portable::{Real, copy, in_range, portable, stored};

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

/// Copies the numbers of another section.
#[portable]
pub fn take<R: Real>(coeffs: &mut Coeffs<R>, offered: &Coeffs<R>) {
    if is_driven_by_change::<R>() {
        copy!(coeffs = offered: h, r, g, g2);
    } else {
        copy!(coeffs = offered: b0, b1, b2, a1, a2, preset_s1, preset_s2);
    }
}

/// Compares the number whose turn it is with its copy; turns are numbered from `first`. Returns the turn after the last one.
#[portable]
pub fn compare<R: Real>(state: &mut turn::State, turn: i32, first: i32, now: &Coeffs<R>, copy: &Coeffs<R>) -> i32 {
    let mut at = first;
    if is_driven_by_change::<R>() {
        for i in 0..4 {
            if turn == at {
                let numbers = [stored(now.h), stored(now.r), stored(now.g), stored(now.g2)];
                let copies = [copy.h, copy.r, copy.g, copy.g2];
                let difference = numbers[i] - copies[i];
                state.next = if in_range(difference, R::ZERO) { at + 1i32 } else { turn::differed() };
            }
            at += 1i32;
        }
    } else {
        for i in 0..7 {
            if turn == at {
                let numbers = [
                    stored(now.b0),
                    stored(now.b1),
                    stored(now.b2),
                    stored(now.a1),
                    stored(now.a2),
                    stored(now.preset_s1),
                    stored(now.preset_s2),
                ];
                let copies = [copy.b0, copy.b1, copy.b2, copy.a1, copy.a2, copy.preset_s1, copy.preset_s2];
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
        let mut is_sound = false;
        if in_range(coeffs.h, largest_number())
            && in_range(coeffs.r, largest_number())
            && in_range(coeffs.g, largest_number())
            && in_range(coeffs.g2, largest_number())
        {
            is_sound = are_poles_inside(coeffs.g * coeffs.h, coeffs.g * coeffs.r, coeffs.g2);
        }
        is_sound
    } else {
        in_range(coeffs.b0, largest_number())
            && in_range(coeffs.b1, largest_number())
            && in_range(coeffs.b2, largest_number())
            && in_range(coeffs.preset_s1, largest_number())
            && in_range(coeffs.preset_s2, largest_number())
            && is_stable_biquad(coeffs.a1, coeffs.a2)
    }
}

/// Adds the numbers to the check word.
#[portable]
pub fn add_up<R: Real>(forming: &mut Forming<R>, coeffs: &Coeffs<R>) {
    if is_driven_by_change::<R>() {
        let numbers = [coeffs.h, coeffs.r, coeffs.g, coeffs.g2];
        for i in 0..4 {
            add(forming, numbers[i]);
        }
    } else {
        let numbers = [coeffs.b0, coeffs.b1, coeffs.b2, coeffs.a1, coeffs.a2, coeffs.preset_s1, coeffs.preset_s2];
        for i in 0..7 {
            add(forming, numbers[i]);
        }
    }
}
