//! Detects corrupted memory: a state that no cycle can produce stops the spindle with an error.

use super::change::lead_time;
use super::motion::ahead;
use super::request::{Job, Request};
use super::signals::Inputs;
use super::state::{Coeffs, Cycle, Seen, SpindleState, State};
use crate::angle::{full_turn, position_limit};
use crate::signal::{
    error_brake, error_call_rate, error_cycle_time, error_half_turn, error_lag, error_mode_display, error_none,
    error_state, error_takeover, error_to_position, error_to_velocity, error_v_interpolator, error_x_actual,
    error_x_command, sample_limit,
};
use portable::{Real, in_range, note, portable};

/// Whether the error that stays is one that may stay in this block.
#[portable]
pub fn may_stay<R: Real>(state: &State<R>, coeffs: &Coeffs<R>) -> bool {
    state.lasting_error == error_none()
        || coeffs.call_rate.active && state.lasting_error == error_call_rate()
        || state.lasting_error == error_cycle_time()
        || state.lasting_error == error_state()
        || state.lasting_error == error_v_interpolator()
        || state.lasting_error == error_x_command()
        || state.lasting_error == error_brake()
        || state.lasting_error == error_to_position()
        || state.lasting_error == error_takeover()
        // A drive with only one mode is not asked to change its mode.
        || coeffs.in_drive
            && (!coeffs.only_velocity && state.lasting_error == error_to_velocity()
                || state.lasting_error == error_half_turn()
                || !coeffs.only_velocity && state.lasting_error == error_mode_display())
        || coeffs.closes_loop && (state.lasting_error == error_lag() || state.lasting_error == error_x_actual())
}

/// Whether the job exists.
#[portable]
pub fn is_job<R: Real>(request: &Request<R>) -> bool {
    request.kind == Job::Stop
        || request.kind == Job::Turn
        || request.kind == Job::Orient
        || request.kind == Job::Release
        || request.kind == Job::Home
}

/// Whether a request is valid.
#[portable]
pub fn is_request<R: Real>(request: &Request<R>) -> bool {
    is_job(request) && in_range(request.speed, sample_limit()) && in_range(request.position, position_limit())
}

/// Whether a usual cycle may output the numbers of the job: one comparison limits both.
#[portable]
pub fn has_usual_numbers<R: Real>(request: &Request<R>) -> bool {
    in_range(request.speed * request.speed + request.position * request.position, squares_limit())
}

/// square of the largest magnitude of a position, and of a speed of a usual cycle
#[portable]
pub fn squares_limit<R: Real>() -> R {
    R::per_kind(4.9e29, 1.0e18)
}

/// Whether the state of the changeover exists, and is that of its copy. Only at the start the block does not move the spindle:
/// memory of zeros, without `init`, is not position control.
#[portable]
pub fn is_state<R: Real>(state: &State<R>, coeffs: &Coeffs<R>) -> bool {
    (!coeffs.only_velocity && state.control == SpindleState::Position
        || state.control == SpindleState::ToVelocity
        || state.control == SpindleState::Velocity
        || state.control == SpindleState::Brake
        || state.control == SpindleState::ToPosition)
        && state.control_copy == state.control
        && (state.is_moving || state.control == SpindleState::ToPosition)
}

/// Limits the counts to their ranges: no count may take for ever.
#[portable]
pub fn hold_counts<R: Real>(state: &mut State<R>) {
    if state.missing > 4u32 {
        state.missing = 4u32;
    }
    if state.settled > 3u32 {
        state.settled = 3u32;
    }
    if state.cycles > largest_count() {
        state.cycles = largest_count();
    }
}

/// upper bound of the cycle count of a state, above any permitted time
#[portable]
pub fn largest_count() -> u32 {
    4_000_000_000u32
}

/// Whether a cycle can have left this position.
#[portable]
pub fn is_position<R: Real>(x: R) -> bool {
    x >= R::ZERO && x < full_turn()
}

/// Whether a cycle can have left these samples.
#[portable]
pub fn is_seen<R: Real>(seen: &Seen<R>) -> bool {
    in_range(seen.v, sample_limit()) && in_range(seen.v_last, sample_limit()) && in_range(seen.v_before, sample_limit())
}

/// Repairs an impossible motion, and only what is impossible in it: the spindle brakes from its velocity, at its position.
/// Returns whether there was something to repair.
#[portable]
pub fn repair_motion<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    let mut is_repaired = false;
    if !in_range(state.v, sample_limit()) {
        state.v = if in_range(inputs.v_actual, sample_limit()) { inputs.v_actual } else { R::ZERO };
        is_repaired = true;
    }
    if !is_position(state.x) {
        state.x = R::ZERO;
        if in_range(inputs.x_actual, position_limit()) {
            let lead = lead_time(coeffs, inputs);
            let x_turning = ahead(inputs.x_actual, state.v * lead);
            state.x = x_turning;
        }
        is_repaired = true;
    }
    // Only TO_POSITION uses it.
    if state.control == SpindleState::ToPosition && !is_position(state.x_start) {
        state.x_start = state.x;
        is_repaired = true;
    }
    is_repaired
}

/// Repairs impossible samples of a spindle that the block does not move yet. Otherwise nothing reads them.
#[portable]
pub fn repair_seen<R: Real>(state: &mut State<R>, cycle: &mut Cycle<R>) {
    if !is_seen(&state.seen) {
        state.seen.v = R::ZERO;
        state.seen.v_last = R::ZERO;
        state.seen.v_before = R::ZERO;
        state.lasting_error = error_state();
        cycle.forgets = true;
    }
}

/// Repairs an impossible state: the spindle stops.
#[portable]
pub fn repair<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    cycle: &mut Cycle<R>,
    is_job: bool,
) {
    note("memory that no cycle can have left is repaired, and the spindle stops");
    hold_counts(state);
    let is_error = may_stay(state, coeffs);
    let is_control = is_state(state, coeffs);
    cycle.forgets = repair_motion(state, coeffs, inputs);
    let is_intact = is_error && is_control && !cycle.forgets && is_job && state.queued <= 4u32;
    if !is_intact {
        state.lasting_error = error_state();
    }
    if state.queued > 4u32 {
        state.queued = 0u32;
    }
    cycle.control = if is_control { state.control } else { SpindleState::ToPosition };
    cycle.begins = !is_control;
}
