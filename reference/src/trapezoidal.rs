//! The second-order sections of single precision: a state-variable filter by the trapezoidal rule, with precomputed
//! coefficients.
//!
//! With the warped centre g, the reciprocal quality factor k, the gain c at the centre and h = 1 / (1 + (g + k) g):
//!
//! ```text
//! u = A p - B s1 ; s1' = s1 + u ; y = s1 + s1' ; low' = low + C y     A = g h c k, B = 2 (g + k) g h, C = 2 g / (c k)
//! ```
//!
//! s1 is half of the integral of the trapezoidal rule: this saves one rounding per cycle, and y needs none.
//!
//! p is the input minus its low-pass part, p = x - low. If the input has an offset, p itself is the state: it is driven by the
//! change of the input, so that no state contains the offset. After a band-pass section low is the state, and no change is
//! needed.

use crate::section::{State, least_change};
use portable::{Real, portable};

/// One cycle driven by the change of the input since the previous cycle: returns the band-pass part of the input.
#[portable]
pub fn by_change<R: Real>(state: &mut State<R>, a: R, b: R, c: R, change: R) -> R {
    let left = state.p + change;
    let u = a * left - b * state.s1;
    let next = state.s1 + u;
    let y = state.s1 + next;
    state.s1 = next;
    state.p = left - c * y;
    y
}

/// One cycle driven by the input itself: returns its band-pass part.
#[portable]
pub fn by_input<R: Real>(state: &mut State<R>, a: R, b: R, c: R, x: R) -> R {
    let u = a * (x - state.low) - b * state.s1;
    let next = state.s1 + u;
    let y = state.s1 + next;
    state.s1 = next;
    state.low = state.low + (c * y + least_change());
    y
}

/// Sets the state to the steady state, which is the same for every constant input.
#[portable]
pub fn preset_by_change<R: Real>(state: &mut State<R>) {
    state.s1 = R::ZERO;
    state.p = R::ZERO;
}

/// Sets the state to the steady state for a constant input `x`.
#[portable]
pub fn preset_by_input<R: Real>(state: &mut State<R>, x: R) {
    state.s1 = R::ZERO;
    state.low = x;
}
