//! The change of a signal since the previous cycle: the input of the sections of single precision. No section.

use crate::section::least_change;
use portable::{Real, portable};

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// the value of the previous cycle
    pub before: R,
}

/// The change since the previous cycle, plus a constant that keeps the driven sections out of the subnormal range.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, x: R) -> R {
    let change = x - state.before;
    state.before = x;
    change + least_change()
}

/// Sets the state to the steady state for a constant `x`: the next change is relative to `x`.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, x: R) {
    state.before = x;
}
