//! The five states: the outputs of each, and when it ends. An error that is set here stops the spindle in the same cycle.

use super::change::{complete, is_displayed};
use super::jobs::is_free;
use super::signals::Inputs;
use super::start::start;
use super::state::{Coeffs, Cycle, SpindleState, State};
use crate::angle::{position_limit, shortest};
use crate::signal::{
    error_brake, error_half_turn, error_mode_display, error_none, error_takeover, error_to_position, error_to_velocity,
    error_v_actual, error_v_interpolator, error_x_actual, error_x_command, sample_limit,
};
use portable::{Real, from_u32, in_range, note, portable, within};

/// Whether the drive cannot detect the direction of the motion.
#[portable]
pub fn is_half_turn<R: Real>(coeffs: &Coeffs<R>, v: R) -> bool {
    coeffs.in_drive && !within(v, coeffs.v_largest)
}

/// A cycle without a sample that its state needs: the spindle continues as before, and stops if this lasts.
#[portable]
pub fn coast<R: Real>(state: &mut State<R>, cycle: &mut Cycle<R>) {
    note("a sample is missing: the spindle goes on as before, and stops if this lasts");
    cycle.sample_error = cycle.lacking;
    state.missing += 1u32;
    state.takes_over = true;
    if state.missing > 3u32 {
        state.lasting_error = cycle.lacking;
    } else {
        cycle.advances = true;
    }
}

/// The interpolator moves the spindle; in VELOCITY with its velocity alone, never with the position controller's.
#[portable]
pub fn track<R: Real>(state: &mut State<R>, inputs: &Inputs<R>, cycle: &mut Cycle<R>) {
    state.missing = 0u32;
    state.takes_over = false;
    state.v = inputs.v_interpolator;
    if cycle.control != SpindleState::Velocity {
        state.x = inputs.x_command;
    } else if in_range(inputs.x_actual, position_limit()) {
        state.x = inputs.x_actual;
    } else {
        cycle.advances = true;
    }
}

/// Whether the interpolator, which takes over, goes on from where the spindle is. Since the last valid sample it may have
/// accelerated.
#[portable]
pub fn goes_on<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, x_command: R) -> bool {
    let x_step = shortest(x_command - (state.x + state.v * coeffs.cycle_time));
    let takeover_cycles = from_u32::<R>(state.missing + 1u32);
    let takeover_further = coeffs.takeover_way * (takeover_cycles * (takeover_cycles + R::ONE));
    within(x_step, coeffs.takeover_window + takeover_further)
}

/// Whether the interpolator can move the spindle in this cycle. Otherwise the spindle coasts, or stops.
#[portable]
pub fn is_led<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    cycle: &mut Cycle<R>,
    mode_fits: bool,
) -> bool {
    let needs_position = cycle.control != SpindleState::Velocity;
    let mut leads = false;
    if !in_range(inputs.v_interpolator, sample_limit()) {
        cycle.lacking = error_v_interpolator();
    } else if needs_position && !in_range(inputs.x_command, position_limit()) {
        cycle.lacking = error_x_command();
    } else if coeffs.closes_loop && needs_position && !in_range(inputs.x_actual, position_limit()) {
        cycle.lacking = error_x_actual();
    } else if !mode_fits {
        cycle.lacking = error_mode_display();
    } else if needs_position && is_half_turn(coeffs, inputs.v_interpolator) {
        state.lasting_error = error_half_turn();
    } else {
        leads = true;
        if needs_position && state.takes_over {
            leads = goes_on(state, coeffs, inputs.x_command);
            if !leads {
                state.lasting_error = error_takeover();
            }
        }
    }
    leads
}

/// POSITION: the interpolator moves the spindle under position control. VELOCITY: its velocity does. TO_VELOCITY: the
/// drive may obey the position or the velocity.
#[portable]
pub fn interpolated<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle<R>) {
    let is_velocity_displayed = is_displayed(coeffs, inputs, coeffs.velocity_mode);
    let mut mode_fits = true;
    if cycle.control == SpindleState::Position {
        mode_fits = is_displayed(coeffs, inputs, coeffs.position_mode);
    } else if cycle.control == SpindleState::Velocity {
        mode_fits = is_velocity_displayed;
    } else {
        state.asks_velocity = true;
    }
    let leads = is_led(state, coeffs, inputs, cycle, mode_fits);
    let is_changing = cycle.control == SpindleState::ToVelocity;
    if leads && is_changing && !is_velocity_displayed && state.cycles > coeffs.mode_cycles {
        state.lasting_error = error_to_velocity();
    } else if leads {
        track(state, inputs, cycle);
        let is_reached = inputs.v_interpolator >= coeffs.v_velocity_control_on
            || -inputs.v_interpolator >= coeffs.v_velocity_control_on;
        if cycle.control == SpindleState::Position {
            if state.turns_fast && is_reached && !inputs.reset {
                note("POSITION -> TO_VELOCITY: M3 or M4 with more than Von, and Von is reached");
                cycle.next = SpindleState::ToVelocity;
            }
        } else if is_changing {
            if is_velocity_displayed {
                if coeffs.in_drive {
                    note("TO_VELOCITY -> VELOCITY: the drive displays velocity control");
                } else {
                    note("TO_VELOCITY -> VELOCITY: the CNC opens its position loop");
                }
                cycle.next = SpindleState::Velocity;
            }
        } else {
            let first_is_free = is_free(&state.request[0]);
            if state.returns || state.queued > 0u32 && !first_is_free {
                note("VELOCITY -> BRAKE: M19, G74, S[PUTAX] or a reset");
                state.returns = false;
                cycle.next = SpindleState::Brake;
            }
        }
    }
}

/// Whether the previous velocity command is at most Voff, and the actual velocity is between 0 and it, or beyond by at most the
/// window. A spindle that still turns the other way has not slowed down: position control would reverse it.
#[portable]
pub fn has_slowed_down<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, v_actual: R) -> bool {
    let is_backward = state.v < R::ZERO;
    let v_magnitude = if is_backward { -state.v } else { state.v };
    let v_along = if is_backward { -v_actual } else { v_actual };
    within(state.v, coeffs.v_position_control_on) && v_along <= v_magnitude + coeffs.window && -v_along <= coeffs.window
}

/// BRAKE: down to Voff, until the actual velocity has been there for three cycles. A spindle that was caught needs
/// the drive's answer.
#[portable]
pub fn brake<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    cycle: &mut Cycle<R>,
    is_known: bool,
) {
    if is_displayed(coeffs, inputs, coeffs.velocity_mode) {
        state.catches = false;
    }
    let mut has_slowed = false;
    if is_known {
        has_slowed = has_slowed_down(state, coeffs, inputs.v_actual);
    }
    if has_slowed {
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
        cycle.brakes = true;
        cycle.advances = true;
        if can_leave {
            note("BRAKE -> TO_POSITION: the actual velocity has settled at Voff");
            cycle.resynchronises = true;
            cycle.next = SpindleState::ToPosition;
        }
    }
}

/// TO_POSITION after BRAKE: the drive may obey the velocity or the position. Returns whether position control begins.
#[portable]
pub fn take_up<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle<R>) -> bool {
    state.asks_velocity = false;
    if state.cycles == 1u32 {
        state.x = state.x_start;
    } else {
        cycle.advances = true;
    }
    let completes = is_displayed(coeffs, inputs, coeffs.position_mode);
    if !completes && state.cycles > coeffs.mode_cycles {
        state.lasting_error = error_to_position();
    }
    completes
}

/// TO_POSITION: after BRAKE, or at the start.
#[portable]
pub fn to_position<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle<R>) {
    let completes =
        if state.is_moving { take_up(state, coeffs, inputs, cycle) } else { start(state, coeffs, inputs, cycle) };
    // Without position control, a spindle that is reset stands still here.
    if completes && !(coeffs.only_velocity && inputs.reset) {
        complete(state, coeffs, cycle);
    }
}

/// What the state does.
#[portable]
pub fn act<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    cycle: &mut Cycle<R>,
    is_known: bool,
) {
    if cycle.control != SpindleState::Position && cycle.control != SpindleState::Velocity {
        state.cycles += 1u32;
    }
    match cycle.control {
        SpindleState::Position | SpindleState::ToVelocity | SpindleState::Velocity => {
            interpolated(state, coeffs, inputs, cycle);
        }
        SpindleState::Brake => brake(state, coeffs, inputs, cycle, is_known),
        SpindleState::ToPosition => to_position(state, coeffs, inputs, cycle),
    }
    if cycle.lacking != error_none() {
        coast(state, cycle);
    }
}
