//! What overwrote the memory is shown, and goes no further: a state that no cycle leaves stops the spindle with an error.

use super::request::{Job, Request};
use super::seen::forget;
use super::state::{Coeffs, State};
use crate::angle::{full_turn, position_limit};
use crate::signal::{
    error_call_rate, error_cycle_time, error_lag, error_none, error_state, error_takeover, error_to_velocity,
    error_v_interpolator, error_x_actual, error_x_command, sample_limit,
};
use portable::{Real, in_range, portable};

/// Whether an error is one that may stay in this block.
#[portable]
pub fn may_stay<R: Real>(coeffs: &Coeffs<R>, id: u32) -> bool {
    id == error_none()
        || coeffs.call_rate.active && id == error_call_rate()
        || id == error_cycle_time()
        || id == error_state()
        || id == error_v_interpolator()
        || id == error_x_command()
        || id == error_x_actual()
        || id >= error_to_velocity() && id <= error_takeover()
        || coeffs.closes_loop && id == error_lag()
}

/// Whether the numbers of a request are such that can be asked for.
#[portable]
pub fn is_request<R: Real>(request: &Request<R>) -> bool {
    in_range(request.speed, sample_limit()) && in_range(request.position, position_limit())
}

/// Whether the motion is one that a cycle can have left.
#[portable]
pub fn is_motion<R: Real>(state: &State<R>) -> bool {
    state.x >= R::ZERO
        && state.x < full_turn()
        && state.x_start >= R::ZERO
        && state.x_start < full_turn()
        && in_range(state.v, sample_limit())
        && in_range(state.seen.v, sample_limit())
        && in_range(state.seen.v_last, sample_limit())
        && in_range(state.seen.v_before, sample_limit())
}

/// Puts what is impossible in order: the spindle stops.
#[portable]
pub fn repair<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    let mut is_wrong = !may_stay(coeffs, state.lasting_error) || state.queued > 4u32;
    if state.queued > 4u32 {
        state.queued = 0u32;
    }
    let is_sound = is_motion(state);
    if !is_sound {
        is_wrong = true;
        state.x = R::ZERO;
        state.x_start = R::ZERO;
        state.v = R::ZERO;
        state.seen.v = R::ZERO;
        state.seen.v_last = R::ZERO;
        state.seen.v_before = R::ZERO;
        forget(&mut state.seen);
    }
    if !is_request(&state.present) {
        is_wrong = true;
        state.turns_fast = false;
        state.present.kind = Job::Stop;
        state.present.speed = R::ZERO;
        state.present.position = R::ZERO;
    }
    if is_wrong {
        state.lasting_error = error_state();
    }
}
