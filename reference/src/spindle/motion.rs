//! What the spindle's commands do where the interpolator has no say. No transition.

use super::signals::Inputs;
use super::{Coeffs, Cycle, State};
use crate::angle::{position_limit, wrapped};
use crate::signal::error_x_actual;
use portable::{Real, in_range, portable};

/// The position goes on with the velocity.
#[portable]
pub fn advance<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    state.x = wrapped(state.x + state.v * coeffs.cycle_time);
}

/// A cycle without the sample that its state needs: the spindle goes on as before.
#[portable]
pub fn coast<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, cycle: &mut Cycle, error_id: u32) {
    cycle.error_id = error_id;
    advance(state, coeffs);
}

/// The velocity goes to `v_end` by at most the step of a cycle; above it, or below -v_end where it is negative.
#[portable]
pub fn slow_down<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, v_end: R, v_end_negative: R) {
    if state.v > v_end {
        let v_less = state.v - coeffs.v_step;
        state.v = if v_less > v_end { v_less } else { v_end };
    } else if state.v < v_end_negative {
        let v_more = state.v + coeffs.v_step;
        state.v = if v_more < v_end_negative { v_more } else { v_end_negative };
    }
}

/// An error stops the spindle, whatever the interpolator says.
#[portable]
pub fn stop<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    slow_down(state, coeffs, R::ZERO, R::ZERO);
    advance(state, coeffs);
}

/// The drive is off: the position command stands on the actual position, and the block starts anew afterwards.
#[portable]
pub fn follow<R: Real>(state: &mut State<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    state.v = R::ZERO;
    state.asks_velocity = false;
    state.returns = false;
    state.preset = false;
    state.takes_over = false;
    if in_range(inputs.x_actual, position_limit()) {
        state.x = wrapped(inputs.x_actual);
    } else {
        cycle.error_id = error_x_actual();
    }
}
