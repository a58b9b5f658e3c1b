//! What the spindle's commands do where the interpolator has no say. No transition.

use super::state::{Coeffs, State};
use crate::angle::wrapped;
use portable::{Real, portable};

/// The position command goes on with the velocity command.
#[portable]
pub fn advance<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    state.x = state.x + state.v * coeffs.cycle_time;
}

/// The spindle is led to a position and a velocity.
#[portable]
pub fn move_to<R: Real>(state: &mut State<R>, x: R, v: R) {
    let x_within = wrapped(x);
    state.x = x_within;
    state.v = v;
}

/// The velocity goes towards 0 by at most the step of a cycle, and not beyond `v_end` or, if it is negative, `v_end_negative`.
#[portable]
pub fn slow_down<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, v_end: R, v_end_negative: R) {
    if state.v > v_end {
        state.v = state.v - coeffs.v_step;
        if state.v < v_end {
            state.v = v_end;
        }
    } else if state.v < v_end_negative {
        state.v = state.v + coeffs.v_step;
        if state.v > v_end_negative {
            state.v = v_end_negative;
        }
    }
}
