//! The usual cycle: POSITION or VELOCITY with valid samples, without a request, waiting job or error, and with a position
//! within one turn. It has the same result as `any_cycle` with fewer checks. No transition.

use super::change::is_displayed;
use super::put_out::{put_out_job, put_out_mode};
use super::repair::is_usual_job;
use super::signals::{Inputs, Outputs};
use super::state::{Coeffs, SpindleState, State, usual_none, usual_position, usual_velocity};
use crate::angle::{full_turn, is_within_turn};
use crate::call_rate;
use crate::signal::error_none;
use portable::{Real, in_range, nearest, note, portable};

/// The code of the usual cycle that may be next: that of a state without a transition.
#[portable]
pub fn next_usual<R: Real>(state: &State<R>) -> u32 {
    let is_quiet =
        state.lasting_error == error_none() && state.queued == 0u32 && !state.before.any && !state.takes_over;
    if is_quiet && state.control == SpindleState::Position {
        usual_position()
    } else if is_quiet && state.control == SpindleState::Velocity && !state.returns {
        usual_velocity()
    } else {
        usual_none()
    }
}

/// Whether no input requests a change.
#[portable]
pub fn asks_nothing<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    (inputs.task_cycle_ns == 0u32 || inputs.task_cycle_ns == coeffs.cycle_time_ns)
        && !inputs.m3
        && !inputs.m4
        && !inputs.m5
        && !inputs.m19
        && !inputs.putax
        && !inputs.g74
        && inputs.drive_on
        && !inputs.reset
}

/// Up to this angle the lag is certain, whatever the previous one was: from the largest lag it would take more than 130 deg in a
/// cycle to be here the other way round [0.001 deg]
#[portable]
pub fn certain_lag<R: Real>() -> R {
    R::lit(60_000.0)
}

/// Whether the lag of two positions is certain. One of them may have passed 0.
#[portable]
pub fn is_certain<R: Real>(x_command: R, x_actual: R) -> bool {
    in_range(x_command - x_actual, certain_lag())
        || in_range(x_command - x_actual - full_turn(), certain_lag())
        || in_range(x_command - x_actual + full_turn(), certain_lag())
}

/// Whether the interpolator moves the spindle under position control, and continues to do so.
#[portable]
pub fn stays_in_position<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    !coeffs.only_velocity
        && state.usual == usual_position()
        && asks_nothing(coeffs, inputs)
        && call_rate::is_usual(&state.call_rate, &coeffs.call_rate, inputs.cycle_counter)
        && is_usual_job(&state.present)
        && in_range(inputs.v_interpolator, coeffs.v_usual_position)
        && is_within_turn(inputs.x_command)
        && (!coeffs.closes_loop || is_certain(inputs.x_command, inputs.x_actual))
        && is_displayed(coeffs, inputs, coeffs.position_mode)
}

/// Whether the spindle turns under velocity control, and continues to do so.
#[portable]
pub fn stays_in_velocity<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    state.usual == usual_velocity()
        && asks_nothing(coeffs, inputs)
        && call_rate::is_usual(&state.call_rate, &coeffs.call_rate, inputs.cycle_counter)
        && is_usual_job(&state.present)
        && in_range(inputs.v_interpolator, coeffs.v_usual_velocity)
        && is_within_turn(inputs.x_actual)
        && is_displayed(coeffs, inputs, coeffs.velocity_mode)
}

/// POSITION.
#[portable]
pub fn remain_in_position<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    outputs: &mut Outputs<R>,
) {
    note("the fast path of POSITION: nothing is requested, and all samples are valid");
    call_rate::go_on(&mut state.call_rate, &coeffs.call_rate, inputs.cycle_counter);
    state.x = inputs.x_command;
    state.v = inputs.v_interpolator;
    put_out(state, coeffs, outputs);
    put_out_mode(coeffs, outputs, false);
    outputs.spindle_state = SpindleState::Position;
    outputs.loop_closed = true;
}

/// VELOCITY.
#[portable]
pub fn remain_in_velocity<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    outputs: &mut Outputs<R>,
) {
    note("the fast path of VELOCITY: nothing is requested, and all samples are valid");
    call_rate::go_on(&mut state.call_rate, &coeffs.call_rate, inputs.cycle_counter);
    state.x = inputs.x_actual;
    state.v = inputs.v_interpolator;
    put_out(state, coeffs, outputs);
    put_out_mode(coeffs, outputs, true);
    outputs.spindle_state = SpindleState::Velocity;
    outputs.loop_closed = false;
}

/// The outputs of both usual cycles. The velocity command is within its range.
#[portable]
pub fn put_out<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>) {
    outputs.x_spindle = state.x;
    outputs.v_spindle = state.v;
    if coeffs.in_drive {
        let velocity_increments = coeffs.velocity_scale * state.v;
        outputs.velocity_command = nearest(velocity_increments);
    } else {
        outputs.velocity_command = 0i32;
    }
    outputs.limited = false;
    put_out_job(state, outputs);
    outputs.waiting = 0u32;
    outputs.error_id = error_none();
    outputs.fault = false;
}
