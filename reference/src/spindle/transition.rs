//! The five states: the outputs of each, and when it ends. An error that is set here stops the spindle in the same cycle.

use super::change::{complete, is_displayed};
use super::jobs::is_free;
use super::motion::{advance, slow_down};
use super::signals::Inputs;
use super::start::start;
use super::state::{Coeffs, Cycle, SpindleState, State, leave_for};
use crate::angle::{position_limit, shortest};
use crate::signal::{
    error_brake, error_half_turn, error_mode_display, error_takeover, error_to_position, error_to_velocity,
    error_v_actual, error_v_interpolator, error_x_actual, error_x_command, sample_limit,
};
use portable::{Real, in_range, note, portable, within};

/// Whether the drive cannot detect the direction of the motion.
#[portable]
pub fn is_half_turn<R: Real>(coeffs: &Coeffs<R>, v: R) -> bool {
    coeffs.in_drive && !within(v, coeffs.v_largest)
}

/// A cycle without a sample that its state needs: the spindle continues as before, and stops if this lasts.
#[portable]
pub fn coast<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, cycle: &mut Cycle) {
    let error_id = cycle.lacking;
    cycle.sample_error = error_id;
    state.missing += 1u32;
    state.takes_over = true;
    if state.missing > 3u32 {
        state.lasting_error = error_id;
    } else {
        advance(state, coeffs);
    }
}

/// The interpolator moves the spindle.
#[portable]
pub fn track<R: Real>(state: &mut State<R>, inputs: &Inputs<R>) {
    state.missing = 0u32;
    state.takes_over = false;
    state.x = inputs.x_command;
    state.v = inputs.v_interpolator;
}

/// Whether the position of the interpolator differs from that of the spindle when it takes over.
#[portable]
pub fn is_jump<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, x_command: R) -> bool {
    let mut is_too_far = false;
    if state.takes_over {
        let x_step = shortest(x_command - (state.x + state.v * coeffs.cycle_time));
        is_too_far = !within(x_step, coeffs.takeover_window);
    }
    is_too_far
}

/// Whether the interpolator can move the spindle in this cycle. Otherwise the spindle coasts, or stops.
#[portable]
pub fn is_led<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    cycle: &mut Cycle,
    mode_fits: bool,
) -> bool {
    let mut leads = false;
    if !in_range(inputs.v_interpolator, sample_limit()) {
        cycle.lacking = error_v_interpolator();
    } else if !in_range(inputs.x_command, position_limit()) {
        cycle.lacking = error_x_command();
    } else if coeffs.closes_loop && !in_range(inputs.x_actual, position_limit()) {
        cycle.lacking = error_x_actual();
    } else if !mode_fits {
        cycle.lacking = error_mode_display();
    } else if is_half_turn(coeffs, inputs.v_interpolator) {
        state.lasting_error = error_half_turn();
    } else {
        let jumps = is_jump(state, coeffs, inputs.x_command);
        if jumps {
            state.lasting_error = error_takeover();
        }
        leads = !jumps;
    }
    leads
}

/// POSITION: the interpolator moves the spindle under position control. TO_VELOCITY: the drive may follow the position or
/// the velocity.
#[portable]
pub fn interpolated<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    let is_position = state.control == SpindleState::Position;
    if !is_position {
        state.cycles += 1u32;
        state.asks_velocity = true;
    }
    let leads =
        is_led(state, coeffs, inputs, cycle, !is_position || is_displayed(coeffs, inputs, coeffs.position_mode));
    let is_velocity_displayed = is_displayed(coeffs, inputs, coeffs.velocity_mode);
    if leads && !is_position && !is_velocity_displayed && state.cycles > coeffs.mode_cycles {
        state.lasting_error = error_to_velocity();
    } else if leads {
        track(state, inputs);
        let is_reached = inputs.v_interpolator >= coeffs.v_velocity_control_on
            || -inputs.v_interpolator >= coeffs.v_velocity_control_on;
        if is_position && state.turns_fast && is_reached && !inputs.reset {
            note("POSITION -> TO_VELOCITY: M3 or M4 with more than Von, and Von is reached");
            leave_for(cycle, SpindleState::ToVelocity);
        } else if !is_position && is_velocity_displayed {
            note("TO_VELOCITY -> VELOCITY: the drive displays velocity control");
            leave_for(cycle, SpindleState::Velocity);
        }
    }
}

/// VELOCITY: the interpolator's velocity, never the position controller's.
#[portable]
pub fn velocity<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    if !in_range(inputs.v_interpolator, sample_limit()) {
        cycle.lacking = error_v_interpolator();
    } else if !is_displayed(coeffs, inputs, coeffs.velocity_mode) {
        cycle.lacking = error_mode_display();
    } else {
        state.missing = 0u32;
        state.v = inputs.v_interpolator;
        if in_range(inputs.x_actual, position_limit()) {
            state.x = inputs.x_actual;
        } else {
            advance(state, coeffs);
        }
        if state.returns || state.queued > 0u32 && !is_free(&state.request[0]) {
            note("VELOCITY -> BRAKE: M19, G74, S[PUTAX] or a reset");
            state.returns = false;
            leave_for(cycle, SpindleState::Brake);
        }
    }
}

/// Whether the previous velocity command is at most Voff, and the actual velocity exceeds it by at most the window.
#[portable]
pub fn has_slowed_down<R: Real>(coeffs: &Coeffs<R>, v_before: R, v_actual: R) -> bool {
    let v_magnitude = if v_before < R::ZERO { -v_before } else { v_before };
    within(v_before, coeffs.v_position_control_on) && within(v_actual, v_magnitude + coeffs.window)
}

/// BRAKE: down to Voff, until the actual velocity has been there for three cycles. A spindle that was caught needs the drive's answer.
#[portable]
pub fn brake<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    state.cycles += 1u32;
    if is_displayed(coeffs, inputs, coeffs.velocity_mode) {
        state.catches = false;
    }
    let is_known = in_range(inputs.v_actual, sample_limit());
    let mut is_slow = false;
    if is_known {
        is_slow = has_slowed_down(coeffs, state.v, inputs.v_actual);
    }
    if is_slow {
        state.settled += 1u32;
    } else {
        state.settled = 0u32;
    }
    let is_settled = state.settled >= 3u32;
    let can_leave = is_settled && (coeffs.only_velocity || in_range(inputs.x_actual, position_limit()));
    if !is_known {
        cycle.sample_error = error_v_actual();
    } else if is_settled && !can_leave {
        cycle.sample_error = error_x_actual();
    }
    if !can_leave && state.catches && state.cycles > coeffs.mode_cycles {
        state.lasting_error = error_to_velocity();
    } else if !can_leave && state.cycles > coeffs.brake_cycles {
        state.lasting_error = error_brake();
    } else {
        slow_down(state, coeffs, coeffs.v_position_control_on, coeffs.v_position_control_on_negative);
        advance(state, coeffs);
        if can_leave {
            note("BRAKE -> TO_POSITION: the actual velocity has settled at Voff");
            cycle.resynchronises = true;
        }
    }
}

/// TO_POSITION after BRAKE: the drive may follow the velocity or the position.
#[portable]
pub fn take_up<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    state.asks_velocity = false;
    if state.cycles == 1u32 {
        state.x = state.x_start;
    } else {
        advance(state, coeffs);
    }
    if is_displayed(coeffs, inputs, coeffs.position_mode) {
        complete(state, coeffs, cycle);
    }
}

/// TO_POSITION: after BRAKE, or at the start, whose test takes two more cycles.
#[portable]
pub fn to_position<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    state.cycles += 1u32;
    let is_late = if state.is_moving {
        state.cycles > coeffs.mode_cycles && !is_displayed(coeffs, inputs, coeffs.position_mode)
    } else {
        false
    };
    if is_late {
        state.asks_velocity = false;
        state.lasting_error = error_to_position();
    } else if state.is_moving {
        take_up(state, coeffs, inputs, cycle);
    } else {
        start(state, coeffs, inputs, cycle);
        if state.cycles > coeffs.start_cycles && !cycle.leaves && !cycle.resynchronises {
            state.lasting_error = error_to_position();
        }
    }
}
