//! A delay of N + f cycles, with 0 <= f < 1: the interpolation of two samples that lie a cycle apart.
//!
//! ```text
//! y[n] = (1 - f) x[n-N] + f x[n-N-1]
//! ```
//!
//! Exact for a signal that is linear between its samples, such as the acceleration of a jerk-limited profile; the magnitude
//! falls to cos(pi frequency Ts) at f = 1/2.
//!
//! Every sample is stored twice. If the due sample was corrupted, the present sample is returned instead.

use portable::{Real, in_range, portable};

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
    /// the samples of the previous cycles, the latest first
    pub x: [R; LONGEST],
    /// second copy, to detect corruption
    pub copy: [R; LONGEST],
}

/// Result of a delay.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Delayed<R> {
    /// the delayed sample
    pub y: R,
    /// TRUE: a sample was corrupted, y is the present sample
    pub overwritten: bool,
}

/// Whether the delay is above 0.
#[portable]
pub fn has_memory<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.fractional || coeffs.whole > 0usize
}

/// The delayed sample, from the samples before the present one.
#[portable]
pub fn interpolated<R: Real>(samples: &[R; LONGEST], coeffs: &Coeffs<R>, x: R) -> R {
    let mut x_whole = x;
    if coeffs.whole > 0usize {
        x_whole = samples[coeffs.whole - 1];
    }
    let mut y = x_whole;
    if coeffs.fractional {
        y = coeffs.now * x_whole + coeffs.before * samples[coeffs.whole];
    }
    y
}

/// Shifts the samples by one cycle and stores the present one.
#[portable]
pub fn shift<R: Real>(samples: &mut [R; LONGEST], x: R) {
    for k in 0..LONGEST {
        // From the oldest sample on.
        samples[LONGEST - 1 - k] = if k + 1usize < LONGEST { samples[LONGEST - 2 - k] } else { x };
    }
}

/// Whether the samples from which the delayed one is interpolated are uncorrupted.
#[portable]
pub fn is_intact<R: Real>(state: &State<R>, coeffs: &Coeffs<R>) -> bool {
    let mut intact = true;
    if coeffs.whole > 0usize {
        intact = in_range(state.x[coeffs.whole - 1] - state.copy[coeffs.whole - 1], R::ZERO);
    }
    if coeffs.fractional {
        intact = intact && in_range(state.x[coeffs.whole] - state.copy[coeffs.whole], R::ZERO);
    }
    intact
}

/// One cycle: takes the input, returns the delayed one.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R, delayed: &mut Delayed<R>) {
    delayed.overwritten = false;
    if has_memory(coeffs) {
        let intact = is_intact(state, coeffs);
        delayed.overwritten = !intact;
        delayed.y = if intact { interpolated(&state.x, coeffs, x) } else { x };
        shift(&mut state.x, x);
        shift(&mut state.copy, x);
    } else {
        delayed.y = x;
    }
}

/// Fills the delay with a sample, as if it had always been there.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, x: R) {
    for k in 0..LONGEST {
        state.x[k] = x;
        state.copy[k] = x;
    }
}
