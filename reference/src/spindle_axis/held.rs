//! What the drive of a position loop got last. It keeps that velocity while a sample is missing, and an error that stops the
//! spindle begins to brake from it.

use super::signals::Inputs;
use super::state::{Coeffs, Command, State, is_in_cnc};
use crate::feedforward;
use crate::position_control::Location;
use crate::signal::sample_limit;
use crate::spindle::{self, SpindleState};
use portable::{Real, copy, in_range, note, portable};

/// No command.
#[portable]
pub fn init<R: Real>(held: &mut Command<R>) {
    held.v_command = R::ZERO;
    held.v_additive = R::ZERO;
}

/// Keeps the command of a cycle under position control.
#[portable]
pub fn keep<R: Real>(held: &mut Command<R>, coeffs: &Coeffs<R>, v_command: R, v_additive: R) {
    if coeffs.axis.position_control.location == Location::Cnc {
        held.v_command = v_command;
    }
    if coeffs.axis.position_control.additive {
        held.v_additive = v_additive;
    }
}

/// The whole velocity that the drive got.
#[portable]
pub fn whole<R: Real>(held: &Command<R>, coeffs: &Coeffs<R>) -> R {
    if coeffs.axis.position_control.additive { held.v_command + held.v_additive } else { held.v_command }
}

/// An error has opened the loop in the CNC: the spindle brakes from the velocity that the drive got, within 0 to v_spindle.
/// Otherwise a lag, the feedforward or a spindle that runs ahead would be a step, and could accelerate the spindle.
#[portable]
pub fn brake<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    let v_whole = whole(&state.held, coeffs);
    if in_range(v_whole, sample_limit()) {
        spindle::hold_back(&mut state.spindle, v_whole);
    } else {
        note("reached only if the block's memory was corrupted");
    }
}

/// The additive velocity for a drive that may still follow positions: the lead of its position command counts on it. In velocity
/// control v_spindle goes out alone.
#[portable]
pub fn additive<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>, v_spindle: R) -> R {
    let mut v_additive = R::ZERO;
    if coeffs.spindle.in_drive
        && !coeffs.spindle.only_velocity
        && coeffs.axis.position_control.additive
        && inputs.operation_mode_display != coeffs.spindle.velocity_mode
    {
        let mut feedforward_inputs = feedforward::Inputs::<R>::default();
        copy!(feedforward_inputs = inputs: feedforward_active, feedforward_percentage);
        let gain_now = feedforward::gain(&coeffs.axis.feedforward, &feedforward_inputs);
        v_additive = gain_now * v_spindle;
    }
    v_additive
}

/// The command of a cycle with an open loop: v_spindle alone. A position loop that misses a sample continues with its last
/// command: the interpolator's velocity differs from it while the spindle accelerates. Every other way to a closed loop leads
/// through BRAKE or TO_POSITION.
#[portable]
pub fn command_of_open<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    spindle_outputs: &spindle::Outputs<R>,
    command: &mut Command<R>,
    is_position: bool,
) {
    command.v_command = spindle_outputs.v_spindle;
    command.v_additive = additive(coeffs, inputs, spindle_outputs.v_spindle);
    if is_position {
        note("a sample is missing: the drive keeps its last command");
        if is_in_cnc(coeffs) && in_range(state.held.v_command, sample_limit()) {
            command.v_command = state.held.v_command;
        }
        if coeffs.axis.position_control.additive && in_range(state.held.v_additive, sample_limit()) {
            command.v_additive = state.held.v_additive;
        }
    } else if spindle_outputs.spindle_state == SpindleState::Brake
        || spindle_outputs.spindle_state == SpindleState::ToPosition
    {
        state.held.v_command = command.v_command;
        state.held.v_additive = command.v_additive;
        if is_in_cnc(coeffs) {
            state.lag_before = R::ZERO;
        }
    }
}
