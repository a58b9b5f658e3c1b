//! From the changeover and the axis to the outputs of the block. No state is changed.

use super::signals::Outputs;
use super::state::Coeffs;
use crate::signal::error_unstable;
use crate::{axis, process_data, spindle};
use portable::{Real, copy, portable};

/// Writes the outputs of the changeover.
#[portable]
pub fn put_out_changeover<R: Real>(spindle_outputs: &spindle::Outputs<R>, outputs: &mut Outputs<R>) {
    copy!(outputs = spindle_outputs:
        x_spindle, v_spindle, job_speed, job_position, spindle_state, job, job_number, waiting, operation_mode,
        loop_closed);
}

/// Writes the velocity command of the drive, without the additive velocity of the feedforward: in the cycles of a change the
/// drive may be in either mode, and in velocity control it adds both.
#[portable]
pub fn put_out_velocity<R: Real>(
    coeffs: &Coeffs<R>,
    spindle_outputs: &spindle::Outputs<R>,
    outputs: &mut Outputs<R>,
    v_additive: R,
) {
    if coeffs.spindle.in_drive && coeffs.spindle.has_feedforward {
        let mut datum = process_data::Datum::default();
        let command_increments = coeffs.spindle.velocity_scale * (spindle_outputs.v_spindle - v_additive);
        process_data::round(&mut datum, &coeffs.spindle.velocity_range, command_increments);
        outputs.velocity_command = datum.value;
        if datum.limited {
            outputs.limited = true;
        }
    } else {
        outputs.velocity_command = spindle_outputs.velocity_command;
    }
}

/// Writes the outputs of the axis.
#[portable]
pub fn put_out<R: Real>(
    coeffs: &Coeffs<R>,
    spindle_outputs: &spindle::Outputs<R>,
    axis_outputs: &axis::Outputs<R>,
    outputs: &mut Outputs<R>,
) {
    copy!(outputs = axis_outputs:
        v_command, v_feedforward, v_add, v_add_calculated, x_drive, manipulated_variable, additive_torque,
        additive_velocity, held, tripped);
    // With feedforward another velocity may go out.
    outputs.limited = if coeffs.spindle.in_drive && !coeffs.spindle.has_feedforward {
        spindle_outputs.limited || axis_outputs.limited
    } else {
        axis_outputs.limited
    };
}

/// If the watch has tripped and there is no fault, reports its id.
#[portable]
pub fn tell_trip<R: Real>(coeffs: &Coeffs<R>, axis_outputs: &axis::Outputs<R>, outputs: &mut Outputs<R>) {
    if coeffs.axis.ipc.watch.active && axis_outputs.tripped && !outputs.fault {
        outputs.error_id = error_unstable();
    }
}
