//! The whole axis of a spindle: the changeover moves the axis, whose position loop is open under velocity control.
//!
//! ```text
//! spindle   requests, interpolator, actual values    -> x_spindle, v_spindle, state, operation mode
//! axis      x_spindle, v_spindle, actual values      -> what the drive gets, while it follows the position
//! ```
//!
//! In VELOCITY and BRAKE, and in TO_POSITION with position control in the CNC, the drive gets only v_spindle: no position
//! controller, no feedforward, no improved position control. A drive that does not display velocity control may still follow
//! positions: part of v_spindle then goes out as the additive velocity that the lead of its position command counts on.

#![expect(clippy::field_reassign_with_default, reason = "portable Rust makes a struct by its default alone")]

mod closed_loop;
mod held;
mod open_loop;
mod put_out;
mod signals;
mod state;

pub use signals::{Inputs, Outputs};
pub(crate) use signals::{inputs, outputs};
pub use state::{Coeffs, Command, State};

use crate::angle::certain;
use crate::signal::error_none;
use crate::spindle::SpindleState;
use crate::{axis, ipc, spindle};
use closed_loop::{close, give_up, lag_limit, lag_of};
use open_loop::{open, remain_open};
use portable::{Block, Enable, Real, copy, note, portable, within};
use put_out::{put_out_changeover, put_out_velocity};
use state::is_in_cnc;

/// Before the first cycle.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    spindle::init(&mut state.spindle);
    axis::init(&mut state.axis);
    state.lag_before = R::ZERO;
    held::init(&mut state.held);
}

/// Copies the inputs of the changeover.
#[portable]
pub fn read<R: Real>(spindle_inputs: &mut spindle::Inputs<R>, inputs: &Inputs<R>) {
    copy!(spindle_inputs = inputs:
        x_command, v_interpolator, x_actual, v_actual, s_word, s_position, m3, m4, m5, m19, putax, g74, job_done,
        drive_on, operation_mode_display, feedforward_active, feedforward_percentage, reset, task_cycle_ns,
        cycle_counter);
}

/// Whether the drive may follow the position command in this cycle, so that the axis acts.
#[portable]
pub fn follows_position<R: Real>(coeffs: &Coeffs<R>, control: SpindleState) -> bool {
    !coeffs.spindle.only_velocity
        && (control == SpindleState::Position
            || control == SpindleState::ToVelocity
            || coeffs.spindle.in_drive && control == SpindleState::ToPosition)
}

/// Any cycle. Only the samples that the spindle uses are checked.
#[portable]
pub fn any_cycle<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    spindle_inputs: &spindle::Inputs<R>,
    outputs: &mut Outputs<R>,
) {
    // The spindle repairs a corrupted count only below.
    let missed = if state.spindle.missing > 4u32 { 4u32 } else { state.spindle.missing };
    let v_missed = state.spindle.v;
    let had_failed = state.spindle.lasting_error != error_none();
    let mut spindle_outputs = spindle::Outputs::<R>::default();
    spindle::any_cycle(&mut state.spindle, &coeffs.spindle, spindle_inputs, &mut spindle_outputs);
    let follows = follows_position(coeffs, spindle_outputs.spindle_state);
    let has_failed = state.spindle.lasting_error != error_none();
    if is_in_cnc(coeffs) && follows && has_failed && !had_failed {
        held::brake(state, coeffs);
        spindle_outputs.v_spindle = state.spindle.v;
    }
    // A spindle that is stopped, or continues without the interpolator, moves by its velocity command only. With the drive off
    // the state is TO_POSITION.
    let is_position = follows && !has_failed && (is_in_cnc(coeffs) || inputs.drive_on);
    if is_position && state.spindle.missing == 0u32 {
        let mut lag = R::ZERO;
        if is_in_cnc(coeffs) {
            lag = lag_of(state, coeffs, inputs, spindle_outputs.x_spindle, missed, v_missed);
        }
        close(state, coeffs, inputs, &spindle_outputs, outputs, lag);
        if is_in_cnc(coeffs) && !within(lag, lag_limit()) {
            give_up(state, coeffs, outputs);
        }
        put_out_velocity(coeffs, &spindle_outputs, outputs, state.held.v_additive);
    } else {
        let mut command = Command::<R>::default();
        held::command_of_open(state, coeffs, inputs, &spindle_outputs, &mut command, is_position);
        open(state, coeffs, &spindle_outputs, outputs, &command);
        put_out_velocity(coeffs, &spindle_outputs, outputs, command.v_additive);
    }
    put_out_changeover(&spindle_outputs, outputs);
}

/// One cycle.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    ipc::rearm(&mut state.axis.ipc, &coeffs.axis.ipc, inputs.mode, inputs.reset);
    go_on(state, coeffs, inputs, outputs);
}

/// The rest of the cycle, after the watch has been rearmed.
#[portable]
pub fn go_on<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    let mut spindle_inputs = spindle::Inputs::<R>::default();
    read(&mut spindle_inputs, inputs);
    let improves = axis::improves(&coeffs.axis);
    if spindle::stays_in_position(&state.spindle, &coeffs.spindle, &spindle_inputs)
        && (!improves
            || ipc::is_settled(&state.axis.ipc, &coeffs.axis.ipc, inputs.mode, inputs.v_motor, inputs.v_direct))
    {
        let mut spindle_outputs = spindle::Outputs::<R>::default();
        spindle::remain_in_position(&mut state.spindle, &coeffs.spindle, &spindle_inputs, &mut spindle_outputs);
        let mut lag = R::ZERO;
        if is_in_cnc(coeffs) {
            lag = certain(spindle_outputs.x_spindle - inputs.x_actual);
        }
        close(state, coeffs, inputs, &spindle_outputs, outputs, lag);
        put_out_changeover(&spindle_outputs, outputs);
        put_out_velocity(coeffs, &spindle_outputs, outputs, state.held.v_additive);
    } else if spindle::stays_in_velocity(&state.spindle, &coeffs.spindle, &spindle_inputs) {
        let mut spindle_outputs = spindle::Outputs::<R>::default();
        spindle::remain_in_velocity(&mut state.spindle, &coeffs.spindle, &spindle_inputs, &mut spindle_outputs);
        remain_open(state, coeffs, &spindle_outputs, outputs);
    } else if spindle::stays_in_brake(&state.spindle, &coeffs.spindle, &spindle_inputs) {
        let mut spindle_outputs = spindle::Outputs::<R>::default();
        spindle::remain_in_brake(&mut state.spindle, &coeffs.spindle, &spindle_inputs, &mut spindle_outputs);
        state.held.v_command = spindle_outputs.v_spindle;
        state.held.v_additive = R::ZERO;
        remain_open(state, coeffs, &spindle_outputs, outputs);
    } else {
        note("any other cycle: requests, changes of the state, missing samples, errors");
        any_cycle(state, coeffs, inputs, &spindle_inputs, outputs);
    }
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct SpindleAxis;

impl<R: Real> Block<R> for SpindleAxis {
    types_init_and_step!(R, State<R>);

    const NAME: &'static str = "spindle_axis";
    const FRACTIONS: &'static [&'static str] = ipc::tuning::INPUTS;

    fn enable(coeffs: &Coeffs<R>) -> Option<Enable> {
        Some(spindle::enable(coeffs.spindle.only_velocity))
    }

    fn is_usual_first(_: &Coeffs<R>) -> bool {
        true
    }

    fn inputs(coeffs: &Coeffs<R>) -> Inputs<R> {
        Inputs {
            mode: coeffs.axis.ipc.enable,
            feedforward_percentage: 100,
            tuning_weight: coeffs.axis.ipc.tuning.weight,
            tuning_limit: coeffs.axis.ipc.tuning.limit,
            ..Inputs::default()
        }
    }

    fn exercise(inputs: &mut Inputs<R>, coeffs: &Coeffs<R>) {
        inputs.mode = ipc::mode_on();
        (inputs.tuning_weight, inputs.tuning_limit) = ([R::ONE; ipc::STAGES], R::ONE);
        inputs.feedforward_active = true;
        inputs.feedforward_percentage = 87;
        inputs.drive_on = true;
        inputs.operation_mode_display = coeffs.spindle.position_mode;
    }
}
