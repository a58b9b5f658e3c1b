//! What a signal has changed by since the cycle before: the input of the sections of single precision. No section.

use crate::section::least_change;
use portable::{Real, portable};

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// the value of the cycle before
    pub before: R,
}

/// The change since the cycle before, with what keeps the sections that it drives out of the subnormal range.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, x: R) -> R {
    let change = x - state.before;
    state.before = x;
    change + least_change()
}

/// Puts the state where a constant `x` would have brought it: the next change is counted from there.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, x: R) {
    state.before = x;
}
