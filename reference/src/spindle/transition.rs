//! The five states: what each puts out, and when it ends. An error that is set here stops the spindle in the same cycle.

use super::motion::{advance, coast, slow_down};
use super::signals::Inputs;
use super::{Coeffs, Cycle, Job, Request, SpindleState, State, enter, jobs};
use crate::angle::{position_limit, shortest, wrapped};
use crate::signal::{
    error_brake, error_half_turn, error_mode_display, error_takeover, error_to_position, error_to_velocity,
    error_v_actual, error_v_interpolator, error_x_actual, error_x_command, sample_limit,
};
use portable::{Real, from_i32, in_range, note, portable, within};

/// Whether the drive cannot tell the direction of the motion any more.
#[portable]
pub fn is_half_turn<R: Real>(coeffs: &Coeffs<R>, v: R) -> bool {
    coeffs.in_drive && (v >= coeffs.v_half_turn || -v >= coeffs.v_half_turn)
}

/// Whether the drive says that it is in a mode; the CNC always is.
#[portable]
pub fn is_displayed<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>, mode: i32) -> bool {
    !coeffs.in_drive || inputs.operation_mode_display == mode
}

/// The interpolator moves the spindle.
#[portable]
pub fn track<R: Real>(state: &mut State<R>, inputs: &Inputs<R>) {
    state.x = wrapped(inputs.x_command);
    state.v = inputs.v_interpolator;
}

/// Whether the interpolator's command goes on from the spindle's.
#[portable]
pub fn is_smooth<R: Real>(coeffs: &Coeffs<R>, x_command: R, x: R) -> bool {
    let step = shortest(x_command - x);
    within(step, coeffs.takeover_window)
}

/// Whether the job is to turn faster than Von, and the spindle has reached it.
#[portable]
pub fn turns_fast<R: Real>(job: &Request<R>, coeffs: &Coeffs<R>, v: R) -> bool {
    let is_fast = job.speed > coeffs.v_velocity_control_on || -job.speed > coeffs.v_velocity_control_on;
    let is_there = v >= coeffs.v_velocity_control_on || -v >= coeffs.v_velocity_control_on;
    job.kind == Job::Turn && is_fast && is_there
}

/// POSITION: the interpolator moves the spindle under position control.
#[portable]
pub fn position<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    if !in_range(inputs.v_interpolator, sample_limit()) {
        coast(state, coeffs, cycle, error_v_interpolator());
    } else if !in_range(inputs.x_command, position_limit()) {
        coast(state, coeffs, cycle, error_x_command());
    } else if is_half_turn(coeffs, inputs.v_interpolator) {
        state.error_id = error_half_turn();
    } else if !is_displayed(coeffs, inputs, coeffs.position_mode) {
        state.error_id = error_mode_display();
    } else if state.takes_over && !is_smooth(coeffs, inputs.x_command, state.x + state.v * coeffs.cycle_time) {
        state.error_id = error_takeover();
    } else {
        state.takes_over = false;
        track(state, inputs);
        if turns_fast(&state.job, coeffs, inputs.v_interpolator) {
            note("POSITION -> TO_VELOCITY: M3 or M4 with more than Von, and Von is reached");
            enter(state, SpindleState::ToVelocity);
        }
    }
}

/// TO_VELOCITY: the drive may obey the position or the velocity.
#[portable]
pub fn to_velocity<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    state.asks_velocity = true;
    if !in_range(inputs.v_interpolator, sample_limit()) {
        coast(state, coeffs, cycle, error_v_interpolator());
    } else if !in_range(inputs.x_command, position_limit()) {
        coast(state, coeffs, cycle, error_x_command());
    } else if is_half_turn(coeffs, inputs.v_interpolator) {
        state.error_id = error_half_turn();
    } else if is_displayed(coeffs, inputs, coeffs.velocity_mode) {
        note("TO_VELOCITY -> VELOCITY: the drive displays velocity control");
        track(state, inputs);
        enter(state, SpindleState::Velocity);
    } else if state.cycles > coeffs.mode_cycles {
        state.error_id = error_to_velocity();
    } else {
        track(state, inputs);
    }
}

/// VELOCITY: the interpolator's velocity, never the position controller's.
#[portable]
pub fn velocity<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    if !in_range(inputs.v_interpolator, sample_limit()) {
        coast(state, coeffs, cycle, error_v_interpolator());
    } else if !is_displayed(coeffs, inputs, coeffs.velocity_mode) {
        state.error_id = error_mode_display();
    } else {
        state.v = inputs.v_interpolator;
        if in_range(inputs.x_actual, position_limit()) {
            state.x = wrapped(inputs.x_actual);
        } else {
            advance(state, coeffs);
        }
        if state.returns || state.waiting > 0u32 && !jobs::is_free(&state.request[0]) {
            note("VELOCITY -> BRAKE: M19, G74, S[PUTAX] or a reset");
            state.returns = false;
            enter(state, SpindleState::Brake);
        }
    }
}

/// The position command with which position control is taken up: where the actual position is when the command arrives, and the
/// lag that the controller needs for this velocity.
#[portable]
pub fn resynchronised<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> R {
    let mut lead_time = coeffs.lead_time;
    if coeffs.has_feedforward && inputs.feedforward_active && inputs.feedforward_percentage > 0i32 {
        let percentage = if inputs.feedforward_percentage < 100i32 { inputs.feedforward_percentage } else { 100i32 };
        lead_time = coeffs.lead_time - coeffs.lead_time_per_percent * from_i32(percentage);
    }
    wrapped(inputs.x_actual + state.v * lead_time)
}

/// BRAKE: down to Voff, until the actual velocity has been there for three cycles.
#[portable]
pub fn brake<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    if !in_range(inputs.v_actual, sample_limit()) {
        cycle.error_id = error_v_actual();
        state.settled = 0u32;
    } else if within(inputs.v_actual, coeffs.v_settled) {
        state.settled += 1u32;
    } else {
        state.settled = 0u32;
    }
    let is_settled = state.settled >= 3u32;
    let can_leave = is_settled && in_range(inputs.x_actual, position_limit());
    if !can_leave && state.cycles > coeffs.brake_cycles {
        state.error_id = error_brake();
    } else {
        slow_down(state, coeffs, coeffs.v_position_control_on, coeffs.v_position_control_on_negative);
        advance(state, coeffs);
        if can_leave {
            note("BRAKE -> TO_POSITION: the actual velocity has settled at Voff");
            state.x_start = resynchronised(state, coeffs, inputs);
            state.preset = true;
            enter(state, SpindleState::ToPosition);
        } else if is_settled {
            cycle.error_id = error_x_actual();
        }
    }
}

/// TO_POSITION: the drive may obey the velocity or the position.
#[portable]
pub fn to_position<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    state.asks_velocity = false;
    let can_start = state.preset || in_range(inputs.x_actual, position_limit());
    let is_answered = can_start && is_displayed(coeffs, inputs, coeffs.position_mode);
    if !is_answered && state.cycles > coeffs.mode_cycles {
        state.error_id = error_to_position();
    } else {
        if !can_start {
            cycle.error_id = error_x_actual();
        } else if !state.preset {
            state.x = wrapped(inputs.x_actual);
            state.preset = true;
        } else if state.cycles == 1u32 {
            state.x = state.x_start;
        } else {
            advance(state, coeffs);
        }
        if is_answered {
            note("TO_POSITION -> POSITION: the drive displays position control");
            state.takes_over = true;
            enter(state, SpindleState::Position);
        }
    }
}
