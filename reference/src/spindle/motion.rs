//! The spindle's commands where the interpolator does not move it. No transition.

use super::state::{Coeffs, State};
use portable::{Real, in_range, note, portable};

/// The position command advances with the velocity command.
#[portable]
pub fn advance<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    state.x = state.x + state.v * coeffs.cycle_time;
}

/// The velocity changes towards 0 by at most the step of a cycle, and not beyond `v_end` or, if it is negative,
/// `v_end_negative`.
#[portable]
pub fn slow_down<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, v_end: R, v_end_negative: R) {
    if state.v > v_end {
        slow_down_forward(state, coeffs, v_end);
    } else if state.v < v_end_negative {
        slow_down_backward(state, coeffs, v_end_negative);
    }
}

/// The same for a velocity above `v_end`.
#[portable]
pub fn slow_down_forward<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, v_end: R) {
    state.v = state.v - coeffs.v_step;
    if state.v < v_end {
        state.v = v_end;
    }
}

/// The same for a velocity below `v_end_negative`.
#[portable]
pub fn slow_down_backward<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, v_end_negative: R) {
    state.v = state.v + coeffs.v_step;
    if state.v > v_end_negative {
        state.v = v_end_negative;
    }
}

/// largest lead of the position command, above the need of any spindle [0.001 deg]
#[portable]
pub fn lead_limit<R: Real>() -> R {
    R::per_kind(1.0e9, 1.0e7)
}

/// A position that leads another one by a distance. An impossible distance counts as 0.
#[portable]
pub fn ahead<R: Real>(x: R, way: R) -> R {
    let mut ahead = x;
    if in_range(way, lead_limit()) {
        ahead = x + way;
    } else {
        note("reached only if the block's memory was corrupted");
    }
    ahead
}
