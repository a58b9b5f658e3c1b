//! The usual cycle: POSITION, VELOCITY or BRAKE with valid samples, without a request, waiting job or error, and with a position
//! within one turn. It has the same result as `any_cycle` with fewer checks. No transition.

use super::change::is_displayed;
use super::motion::{advance, slow_down_backward, slow_down_forward};
use super::put_out::{put_out_job, put_out_mode};
use super::repair::{has_usual_numbers, is_job};
use super::request::Job;
use super::signals::{Inputs, Outputs};
use super::state::{Coeffs, SpindleState, State, usual_brake, usual_none, usual_position, usual_velocity};
use crate::angle::{below_full_turn, is_certain, is_within_turn};
use crate::call_rate;
use crate::signal::{error_none, sample_limit};
use portable::{Real, in_range, nearest, note, portable, within};

/// The code of the usual cycle that may be next: that of a state without a transition.
#[portable]
pub fn next_usual<R: Real>(state: &State<R>) -> u32 {
    let is_quiet = state.lasting_error == error_none() && !state.before.any;
    let is_led = is_quiet && state.queued == 0u32 && !state.takes_over;
    if is_led && state.control == SpindleState::Position {
        usual_position()
    } else if is_led && state.control == SpindleState::Velocity && !state.returns {
        usual_velocity()
    } else if is_quiet && state.control == SpindleState::Brake {
        usual_brake()
    } else {
        usual_none()
    }
}

/// Whether no input requests a change, and the call comes in time.
#[portable]
pub fn is_regular<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    (inputs.task_cycle_ns == 0u32 || inputs.task_cycle_ns == coeffs.cycle_time_ns)
        && !inputs.m3
        && !inputs.m4
        && !inputs.m5
        && !inputs.m19
        && !inputs.putax
        && !inputs.g74
        && inputs.drive_on
        && !inputs.reset
        && call_rate::is_usual(&state.call_rate, &coeffs.call_rate, inputs.cycle_counter)
}

/// Whether the interpolator moves the spindle under position control, and continues to do so.
#[portable]
pub fn stays_in_position<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    !coeffs.only_velocity
        && state.usual == usual_position()
        && is_regular(state, coeffs, inputs)
        && is_job(&state.present)
        && has_usual_numbers(&state.present)
        && in_range(inputs.v_interpolator, coeffs.v_usual_position)
        && is_within_turn(inputs.x_command)
        && (!coeffs.closes_loop || is_certain(inputs.x_command, inputs.x_actual))
        && is_displayed(coeffs, inputs, coeffs.position_mode)
}

/// Whether the spindle turns under velocity control, and continues to do so.
#[portable]
pub fn stays_in_velocity<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    state.usual == usual_velocity()
        && is_regular(state, coeffs, inputs)
        && is_job(&state.present)
        && has_usual_numbers(&state.present)
        && in_range(inputs.v_interpolator, coeffs.v_usual_velocity)
        && is_within_turn(inputs.x_actual)
        && is_displayed(coeffs, inputs, coeffs.velocity_mode)
}

/// Whether the spindle brakes, and began this cycle faster than Voff. Requests may be waiting. The position, which moves at most
/// as far as with the velocity of the last cycle, stays within the turn. Not the first cycle of BRAKE, and no cycle before the
/// drive of a caught spindle displays velocity control.
#[portable]
pub fn stays_in_brake<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    state.usual == usual_brake()
        && is_regular(state, coeffs, inputs)
        && state.present.kind == Job::Stop
        && has_usual_numbers(&state.present)
        && state.queued <= 4u32
        && state.cycles > 0u32
        && state.cycles < coeffs.brake_cycles
        && in_range(state.v, coeffs.v_usual_velocity)
        && !within(state.v, coeffs.v_position_control_on)
        && in_range(state.x, below_full_turn())
        && state.x >= R::ZERO
        && in_range(state.x + state.v * coeffs.cycle_time, below_full_turn())
        && state.x + state.v * coeffs.cycle_time >= R::ZERO
        && in_range(inputs.v_actual, sample_limit())
        && is_displayed(coeffs, inputs, coeffs.velocity_mode)
        && (!coeffs.in_drive || !state.catches && (coeffs.only_velocity || state.asks_velocity))
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

/// BRAKE, down to Voff.
#[portable]
pub fn remain_in_brake<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    outputs: &mut Outputs<R>,
) {
    note("the fast path of BRAKE: nothing is requested, and the velocity is not yet at Voff");
    call_rate::go_on(&mut state.call_rate, &coeffs.call_rate, inputs.cycle_counter);
    state.cycles += 1u32;
    state.settled = 0u32;
    if state.v > R::ZERO {
        slow_down_forward(state, coeffs, coeffs.v_position_control_on);
    } else {
        slow_down_backward(state, coeffs, coeffs.v_position_control_on_negative);
    }
    advance(state, coeffs);
    put_out(state, coeffs, outputs);
    put_out_mode(coeffs, outputs, true);
    outputs.waiting = state.queued;
    outputs.spindle_state = SpindleState::Brake;
    outputs.loop_closed = false;
}

/// The outputs of all usual cycles. The velocity command is within its range.
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
