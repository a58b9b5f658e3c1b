//! A delay of N + f cycles, with 0 <= f < 1: the interpolation of two samples that lie a cycle apart.
//!
//! ```text
//! y[n] = (1 - f) x[n-N] + f x[n-N-1]
//! ```
//!
//! Exact for a signal that is linear between its samples, as the acceleration of a jerk-limited profile is; the magnitude
//! falls to cos(pi frequency Ts) at f = 1/2.

use portable::{Real, portable};

/// The longest delay is below this many cycles.
pub const LONGEST: usize = 6;

/// Coefficients: the delay is (whole + before) cycles.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// N: whole cycles
    pub whole: usize,
    /// whether f is above 0
    pub fractional: bool,
    /// 1 - f: share of the sample N cycles ago
    pub now: R,
    /// f: share of the sample N + 1 cycles ago
    pub before: R,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// the samples before the present one, the latest first
    pub x: [R; LONGEST],
}

/// One cycle: takes the input, gives the delayed one.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    let mut x_whole = x;
    if coeffs.whole > 0usize {
        x_whole = state.x[coeffs.whole - 1];
    }
    let mut y = x_whole;
    if coeffs.fractional {
        y = coeffs.now * x_whole + coeffs.before * state.x[coeffs.whole];
    }
    for k in 0..LONGEST {
        // From the oldest on: each takes over what the next younger one has.
        state.x[LONGEST - 1 - k] = if k + 1usize < LONGEST { state.x[LONGEST - 2 - k] } else { x };
    }
    y
}

/// Fills the delay with a sample, as if it had always been there.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, x: R) {
    for k in 0..LONGEST {
        state.x[k] = x;
    }
}
