//! The usual cycle: POSITION or VELOCITY with valid samples, without a request, waiting job or error, and with a position
//! within one turn. It has the same result as `any_cycle` with fewer checks. No transition.

use super::change::is_displayed;
use super::put_out::{put_out_job, put_out_mode, put_out_motion};
use super::repair::is_request;
use super::signals::{Inputs, Outputs};
use super::state::{Coeffs, SpindleState, State, usual_none, usual_position, usual_velocity};
use crate::angle::{is_within_turn, position_limit};
use crate::call_rate;
use crate::signal::{error_none, sample_limit};
use portable::{Real, in_range, note, portable};

/// The code of the usual cycle that may be next: that of a state without a transition.
#[portable]
pub fn next_usual<R: Real>(state: &State<R>) -> u32 {
    let is_quiet =
        state.lasting_error == error_none() && state.queued == 0u32 && !state.before.any && !state.takes_over;
    if is_quiet && state.control == SpindleState::Position && !state.turns_fast {
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
    !inputs.m3
        && !inputs.m4
        && !inputs.m5
        && !inputs.m19
        && !inputs.putax
        && !inputs.g74
        && inputs.drive_on
        && !inputs.reset
        && (inputs.task_cycle_ns == 0u32 || inputs.task_cycle_ns == coeffs.cycle_time_ns)
}

/// Whether the interpolator moves the spindle under position control, and continues to do so.
#[portable]
pub fn stays_in_position<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    let v_largest = if coeffs.in_drive { coeffs.v_largest } else { sample_limit() };
    !coeffs.only_velocity
        && state.usual == usual_position()
        && asks_nothing(coeffs, inputs)
        && call_rate::is_usual(&state.call_rate, &coeffs.call_rate, inputs.cycle_counter)
        && is_request(&state.present)
        && in_range(inputs.v_interpolator, v_largest)
        && is_within_turn(inputs.x_command)
        && (!coeffs.closes_loop || in_range(inputs.x_actual, position_limit()))
        && is_displayed(coeffs, inputs, coeffs.position_mode)
}

/// Whether the spindle turns under velocity control, and continues to do so.
#[portable]
pub fn stays_in_velocity<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    state.usual == usual_velocity()
        && asks_nothing(coeffs, inputs)
        && call_rate::is_usual(&state.call_rate, &coeffs.call_rate, inputs.cycle_counter)
        && is_request(&state.present)
        && in_range(inputs.v_interpolator, sample_limit())
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

/// The outputs of both usual cycles.
#[portable]
pub fn put_out<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>) {
    put_out_motion(state, coeffs, outputs);
    put_out_job(state, outputs);
    outputs.waiting = 0u32;
    outputs.error_id = error_none();
    outputs.fault = false;
}
