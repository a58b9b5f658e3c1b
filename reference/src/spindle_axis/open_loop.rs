//! The open position loop: the drive gets only a velocity.

use super::put_out::{put_out, put_out_changeover, tell_trip};
use super::signals::Outputs;
use super::state::{Coeffs, Command, State, is_in_cnc};
use crate::signal::error_none;
use crate::{axis, position_control, spindle};
use portable::{Real, nearest, portable};

/// The position loop is open: the axis only follows the position of the spindle.
#[portable]
pub fn follow<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    spindle_outputs: &spindle::Outputs<R>,
    axis_outputs: &mut axis::Outputs<R>,
) {
    let mut axis_inputs = axis::Inputs::<R>::default();
    axis_inputs.x_command = spindle_outputs.x_spindle;
    axis::follow(&mut state.axis, &coeffs.axis, &axis_inputs, axis_outputs, error_none());
}

/// The velocity of an open loop, as process data.
#[portable]
pub fn command_velocity<R: Real>(coeffs: &Coeffs<R>, command: &Command<R>, axis_outputs: &mut axis::Outputs<R>) {
    let mut control_outputs = position_control::Outputs::<R>::default();
    if is_in_cnc(coeffs) {
        axis_outputs.v_command = command.v_command;
        let open_increments = coeffs.axis.position_control.manipulated_scale * command.v_command;
        axis_outputs.manipulated_variable = position_control::rounded(
            &mut control_outputs,
            &coeffs.axis.position_control.manipulated_range,
            open_increments,
        );
    }
    if coeffs.axis.position_control.additive {
        let added_increments = coeffs.axis.position_control.velocity_scale * command.v_additive;
        axis_outputs.additive_velocity = position_control::rounded(
            &mut control_outputs,
            &coeffs.axis.position_control.velocity_range,
            added_increments,
        );
    }
    axis_outputs.limited = control_outputs.limited;
}

/// Writes the outputs of an open loop.
#[portable]
pub fn put_out_open<R: Real>(
    coeffs: &Coeffs<R>,
    spindle_outputs: &spindle::Outputs<R>,
    axis_outputs: &axis::Outputs<R>,
    outputs: &mut Outputs<R>,
) {
    put_out(coeffs, spindle_outputs, axis_outputs, outputs);
    outputs.error_id = spindle_outputs.error_id;
    outputs.fault = spindle_outputs.error_id != error_none();
    tell_trip(coeffs, axis_outputs, outputs);
}

/// The drive gets only a velocity: that of the spindle, or while a sample is missing the last one.
#[portable]
pub fn open<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    spindle_outputs: &spindle::Outputs<R>,
    outputs: &mut Outputs<R>,
    command: &Command<R>,
) {
    let mut axis_outputs = axis::Outputs::<R>::default();
    follow(state, coeffs, spindle_outputs, &mut axis_outputs);
    command_velocity(coeffs, command, &mut axis_outputs);
    put_out_open(coeffs, spindle_outputs, &axis_outputs, outputs);
}

/// The usual cycle of VELOCITY or BRAKE: the drive gets only the velocity of the spindle, which is within its range.
#[portable]
pub fn remain_open<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    spindle_outputs: &spindle::Outputs<R>,
    outputs: &mut Outputs<R>,
) {
    let mut axis_outputs = axis::Outputs::<R>::default();
    follow(state, coeffs, spindle_outputs, &mut axis_outputs);
    if is_in_cnc(coeffs) {
        axis_outputs.v_command = spindle_outputs.v_spindle;
        let open_increments = coeffs.axis.position_control.manipulated_scale * spindle_outputs.v_spindle;
        axis_outputs.manipulated_variable = nearest(open_increments);
    }
    put_out_open(coeffs, spindle_outputs, &axis_outputs, outputs);
    put_out_changeover(spindle_outputs, outputs);
    outputs.velocity_command = spindle_outputs.velocity_command;
}
