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

mod held;
mod signals;

pub use held::Command;
pub use signals::{Inputs, Outputs};
pub(crate) use signals::{inputs, outputs};

use crate::angle::{full_turn, shortest};
use crate::position_control::Location;
use crate::signal::{error_lag, error_none, error_unstable, sample_limit};
use crate::spindle::{SpindleState, certain_lag, is_certain};
use crate::{axis, ipc, position_control, process_data, spindle};
use portable::{Block, Enable, Real, copy, from_u32, in_range, nearest, note, portable, within};

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// changeover
    pub spindle: spindle::Coeffs<R>,
    /// feedforward, position control, improved position control
    pub axis: axis::Coeffs<R>,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// changeover
    pub spindle: spindle::State<R>,
    /// feedforward, position control, improved position control
    pub axis: axis::State<R>,
    /// position control in the CNC: the position lag of the last cycle with a closed loop, 0 after an open one [0.001 deg]
    pub lag_before: R,
    /// what the drive got last
    pub held: Command<R>,
}

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

/// Whether the CNC controls the position.
#[portable]
pub fn is_in_cnc<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.axis.position_control.location == Location::Cnc && !coeffs.spindle.only_velocity
}

/// largest position lag of a loop in the CNC: above half a turn the loop would turn the spindle the other way [0.001 deg]
#[portable]
pub fn lag_limit<R: Real>() -> R {
    R::lit(170_000.0)
}

/// half a turn [0.001 deg]
#[portable]
pub fn half_turn<R: Real>() -> R {
    R::lit(180_000.0)
}

/// The lag that continues from the previous one: beyond half a turn the shortest way would turn the spindle back. `missed` samples
/// were missing, after the velocity `v_missed`: meanwhile the lag of a spindle that follows has not grown, and that of a blocked one
/// by the whole way.
#[portable]
pub fn continued<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, difference: R, missed: u32, v_missed: R) -> R {
    let mut lag = if within(difference, half_turn()) { difference } else { shortest(difference) };
    if in_range(state.lag_before, lag_limit()) {
        let mut expected = state.lag_before;
        if missed > 0u32 {
            if in_range(v_missed, sample_limit()) {
                let half_cycles = from_u32::<R>(missed + 1u32) * R::lit(0.5);
                expected = expected + v_missed * (coeffs.spindle.cycle_time * half_cycles);
            } else {
                note("reached only if the block's memory was corrupted");
            }
        }
        let lag_step = lag - expected;
        if lag_step > half_turn() {
            lag = lag - full_turn();
        } else if lag_step < -half_turn::<R>() {
            lag = lag + full_turn();
        }
    } else {
        note("reached only if the block's memory was corrupted");
    }
    lag
}

/// The lag of two positions with this difference, if it is certain.
#[portable]
pub fn angle<R: Real>(difference: R) -> R {
    if within(difference, certain_lag()) {
        difference
    } else if difference > R::ZERO {
        difference - full_turn()
    } else {
        difference + full_turn()
    }
}

/// The lag in any cycle. `missed` samples were missing before it, after the velocity `v_missed`.
#[portable]
pub fn lag_of<R: Real>(
    state: &State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    x_spindle: R,
    missed: u32,
    v_missed: R,
) -> R {
    if missed == 0u32 && is_certain(x_spindle, inputs.x_actual) {
        angle(x_spindle - inputs.x_actual)
    } else {
        continued(state, coeffs, x_spindle - inputs.x_actual, missed, v_missed)
    }
}

/// The lag is near half a turn: the error stays, the loop opens in the next cycle, and the spindle brakes.
#[portable]
pub fn give_up<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>) {
    let v_whole = held::whole(&state.held, coeffs);
    spindle::hold_back(&mut state.spindle, v_whole);
    state.spindle.lasting_error = error_lag();
    state.spindle.usual = spindle::usual_none();
    outputs.error_id = error_lag();
    outputs.fault = true;
}

/// The axis follows the spindle's commands.
#[portable]
pub fn act<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    spindle_outputs: &spindle::Outputs<R>,
    axis_outputs: &mut axis::Outputs<R>,
    lag: R,
) {
    let mut axis_inputs = axis::Inputs::<R>::default();
    axis_inputs.x_command = spindle_outputs.x_spindle;
    if coeffs.axis.position_control.location == Location::Cnc {
        state.lag_before = lag;
        axis_inputs.following_error = lag;
        axis_inputs.x_actual = spindle_outputs.x_spindle - lag;
    }
    axis_inputs.v_interpolator = spindle_outputs.v_spindle;
    if spindle_outputs.spindle_state != SpindleState::ToPosition {
        copy!(axis_inputs = inputs: a_interpolator, j_interpolator);
    }
    copy!(axis_inputs = inputs:
        v_motor, v_direct, tuning_weight, tuning_limit, mode, feedforward_active, feedforward_percentage);
    // A reset ends what is added, as everywhere; the position loop still holds the spindle.
    let improves = spindle_outputs.loop_closed && !inputs.reset;
    let v_additive = axis::act(&mut state.axis, &coeffs.axis, &axis_inputs, axis_outputs, improves);
    held::keep(&mut state.held, coeffs, axis_outputs.v_command, v_additive);
}

/// Writes the outputs of the changeover.
#[portable]
pub fn put_out_changeover<R: Real>(spindle_outputs: &spindle::Outputs<R>, outputs: &mut Outputs<R>) {
    copy!(outputs = spindle_outputs:
        x_spindle, v_spindle, job_speed, job_position, spindle_state, job, job_number, waiting, operation_mode,
        loop_closed);
}

/// Writes the velocity command of the drive, without the additive velocity of the feedforward: in the cycles of a change the drive
/// may be in either mode, and in velocity control it adds both.
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

/// Reports the id of the tripped watch if there is no fault.
#[portable]
pub fn tell_trip<R: Real>(coeffs: &Coeffs<R>, axis_outputs: &axis::Outputs<R>, outputs: &mut Outputs<R>) {
    if coeffs.axis.ipc.watch.active && axis_outputs.tripped && !outputs.fault {
        outputs.error_id = error_unstable();
    }
}

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

/// The usual cycle of VELOCITY: the drive gets only the velocity of the spindle, which is within its range.
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
}

/// Under position control: the axis acts.
#[portable]
pub fn close<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    spindle_outputs: &spindle::Outputs<R>,
    outputs: &mut Outputs<R>,
    lag: R,
) {
    let mut axis_outputs = axis::Outputs::<R>::default();
    act(state, coeffs, inputs, spindle_outputs, &mut axis_outputs, lag);
    put_out(coeffs, spindle_outputs, &axis_outputs, outputs);
    let error_now = if axis_outputs.fault { axis_outputs.error_id } else { spindle_outputs.error_id };
    outputs.error_id = error_now;
    outputs.fault = error_now != error_none();
    if coeffs.axis.ipc.tuning.active && error_now == error_none() {
        note("not a fault: a tuning input is invalid, its last valid value stays active");
        outputs.error_id = axis_outputs.error_id;
    }
    tell_trip(coeffs, &axis_outputs, outputs);
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
            lag = angle(spindle_outputs.x_spindle - inputs.x_actual);
        }
        close(state, coeffs, inputs, &spindle_outputs, outputs, lag);
        put_out_changeover(&spindle_outputs, outputs);
        put_out_velocity(coeffs, &spindle_outputs, outputs, state.held.v_additive);
    } else if spindle::stays_in_velocity(&state.spindle, &coeffs.spindle, &spindle_inputs) {
        let mut spindle_outputs = spindle::Outputs::<R>::default();
        spindle::remain_in_velocity(&mut state.spindle, &coeffs.spindle, &spindle_inputs, &mut spindle_outputs);
        remain_open(state, coeffs, &spindle_outputs, outputs);
        put_out_changeover(&spindle_outputs, outputs);
        outputs.velocity_command = spindle_outputs.velocity_command;
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
