//! From the state to the outputs: the motion, the operation mode, the job. No state is changed.

use super::signals::Outputs;
use super::state::{Coeffs, State};
use crate::process_data;
use portable::{Real, portable};

/// The motion, and the velocity for the drive.
#[portable]
pub fn put_out_motion<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>) {
    outputs.x_spindle = state.x;
    outputs.v_spindle = state.v;
    if coeffs.in_drive {
        let mut datum = process_data::Datum::default();
        let velocity_increments = coeffs.velocity_scale * state.v;
        process_data::round(&mut datum, &coeffs.velocity_range, velocity_increments);
        outputs.velocity_command = datum.value;
        outputs.limited = datum.limited;
    } else {
        outputs.velocity_command = 0i32;
        outputs.limited = false;
    }
}

/// The operation mode for the drive.
#[portable]
pub fn put_out_mode<R: Real>(coeffs: &Coeffs<R>, outputs: &mut Outputs<R>, asks_velocity: bool) {
    if coeffs.in_drive {
        let is_velocity = coeffs.only_velocity || asks_velocity;
        outputs.operation_mode = if is_velocity { coeffs.velocity_mode } else { coeffs.position_mode };
    } else {
        outputs.operation_mode = 0i32;
    }
}

/// The job.
#[portable]
pub fn put_out_job<R: Real>(state: &State<R>, outputs: &mut Outputs<R>) {
    outputs.job = state.present.kind;
    outputs.job_speed = state.present.speed;
    outputs.job_position = state.present.position;
    outputs.job_number = state.jobs;
}
