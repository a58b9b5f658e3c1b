//! Position control: the P controller of the CNC, or what the CNC hands to a drive that controls the position itself.
//!
//! ```text
//! in the CNC     v_command            = kv (x_command - x_actual) + v_feedforward
//!                manipulated_variable = manipulated_scale * (v_command + v_add)
//! in the drive   x_drive              = shift(x_command) + lag * v_feedforward
//!                xerr                 = xerr_scale * (x_drive - x_actual)               PROFIdrive
//!                additive_velocity    = velocity_scale * (v_additive + v_add)
//! ```
//!
//! Positions grow in the direction of positive velocity. Integers are rounded half away from zero and saturated.
//!
//! In single precision a position of 3 m is rounded to 0.25 um. The controller in the CNC therefore takes `following_error`
//! instead of both positions; the caller subtracts them in increments or in double precision.

mod signals;

pub use signals::{Inputs, Outputs};

use crate::precision::is_single;
use crate::signal::{
    error_call_rate, error_cycle_time, error_following_error, error_none, error_v_add, error_v_additive,
    error_v_feedforward,
};
use crate::signal::{error_state, error_x_actual, error_x_command, sample_limit};
use crate::sum::empty_sum;
use crate::{call_rate, delay, process_data};
use portable::{Block, Enable, Off, Real, in_range, note, portable};

/// Where the position is controlled.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Location {
    /// in the CNC: the drive gets a velocity
    #[default]
    Cnc,
    /// in the drive: the drive gets a position
    Drive,
    /// in a PROFIdrive drive: the drive gets a control deviation
    Profidrive,
}

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// cycle time that all coefficients were designed for [ns]
    pub cycle_time_ns: u32,
    /// where the position is controlled
    pub location: Location,
    /// whether there is conventional feedforward
    pub feedforward: bool,
    /// whether there is an additive velocity of the feedforward
    pub additive: bool,
    /// whether there is an additive velocity of improved position control
    pub adds: bool,
    /// whether there is an additive torque
    pub torque: bool,
    /// gain of the position controller Kv [1/s]
    pub kv: R,
    /// 1 / Kv of the drive: position lag for a velocity [s]
    pub lag: R,
    /// manipulated variable: increments for 1 um/s or 0.001 deg/s
    pub manipulated_scale: R,
    /// range of the manipulated variable
    pub manipulated_range: process_data::Coeffs<R>,
    /// delay of the position command relative to the feedforward [cycles]
    pub shift: delay::Coeffs<R>,
    /// increments for 1 um or 0.001 deg
    pub xerr_scale: R,
    /// range of the control deviation
    pub xerr_range: process_data::Coeffs<R>,
    /// additive velocity: increments for 1 um/s or 0.001 deg/s
    pub velocity_scale: R,
    /// range of the additive velocity
    pub velocity_range: process_data::Coeffs<R>,
    /// the rate of the calls
    pub call_rate: call_rate::Coeffs,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// TRUE after the delay of the position command has been filled
    pub preset: bool,
    /// delay of the position command relative to the feedforward
    pub shift: delay::State<R>,
    /// the last position command of the drive [um or 0.001 deg]
    pub x_held: R,
    /// the rate of the calls
    pub call_rate: call_rate::State,
    /// second copy, to detect corruption
    pub x_held_copy: R,
}

/// Before the first cycle.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    state.preset = false;
    state.x_held = R::ZERO;
    call_rate::init(&mut state.call_rate);
    state.x_held_copy = R::ZERO;
}

/// Whether the controller takes `following_error` instead of both positions: in single precision.
#[portable]
pub fn takes_following_error<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.location == Location::Cnc && is_single::<R>()
}

/// Whether the actual position, or `following_error` instead, is used.
#[portable]
pub fn reads_actual<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.location != Location::Drive
}

/// Whether the command position is in range or not used.
#[portable]
pub fn is_command_in_range<R: Real>(coeffs: &Coeffs<R>, x_command: R) -> bool {
    takes_following_error(coeffs) || in_range(x_command, sample_limit())
}

/// Whether the actual position, or `following_error` instead, is in range.
#[portable]
pub fn is_actual_in_range<R: Real>(coeffs: &Coeffs<R>, x_actual: R, following_error: R) -> bool {
    if takes_following_error(coeffs) {
        in_range(following_error, sample_limit())
    } else {
        !reads_actual(coeffs) || in_range(x_actual, sample_limit())
    }
}

/// The id of the input that [`is_actual_in_range`] checks.
#[portable]
pub fn error_of_actual<R: Real>(coeffs: &Coeffs<R>) -> u32 {
    if takes_following_error(coeffs) { error_following_error() } else { error_x_actual() }
}

/// The output of the position controller, before v_add is added; 0 if the drive has the position controller.
#[portable]
pub fn command<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> R {
    let mut v_controller = R::ZERO;
    if coeffs.location == Location::Cnc {
        let lag =
            if takes_following_error(coeffs) { inputs.following_error } else { inputs.x_command - inputs.x_actual };
        let v_lag = coeffs.kv * lag;
        v_controller = if coeffs.feedforward { v_lag + inputs.v_feedforward } else { v_lag };
    }
    v_controller
}

/// Sets the integer outputs to 0, for a fault or a cycle without action.
#[portable]
pub fn clear<R: Real>(state: &mut State<R>, outputs: &mut Outputs<R>, error_id: u32) {
    state.preset = false;
    outputs.v_command = R::ZERO;
    outputs.manipulated_variable = 0i32;
    outputs.xerr = 0i32;
    outputs.additive_velocity = 0i32;
    outputs.additive_torque = 0i32;
    outputs.limited = false;
    outputs.fault = error_id != error_none();
    outputs.error_id = error_id;
}

/// A cycle without a command position in range: x_drive keeps its last value.
#[portable]
pub fn hold<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>, error_id: u32) {
    clear(state, outputs, error_id);
    outputs.x_drive = R::ZERO;
    if coeffs.location != Location::Cnc {
        if in_range(state.x_held - state.x_held_copy, R::ZERO) {
            outputs.x_drive = state.x_held;
        } else {
            note("the held position was corrupted and cannot be restored: x_drive is 0, and the error id reports it");
            outputs.error_id = error_state();
        }
    }
}

/// A cycle in which the block must not act: the position command of the drive follows the interpolator.
#[portable]
pub fn follow<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    outputs: &mut Outputs<R>,
    error_id: u32,
) {
    clear(state, outputs, error_id);
    outputs.x_drive = R::ZERO;
    if coeffs.location != Location::Cnc {
        state.x_held = inputs.x_command;
        state.x_held_copy = inputs.x_command;
        outputs.x_drive = inputs.x_command;
    }
}

/// The integer for the process data; `limited` is set if its range cuts the value off.
#[portable]
pub fn rounded<R: Real>(outputs: &mut Outputs<R>, range: &process_data::Coeffs<R>, increments: R) -> i32 {
    let mut datum = process_data::Datum::default();
    process_data::round(&mut datum, range, increments);
    if datum.limited {
        outputs.limited = true;
    }
    datum.value
}

/// The manipulated variable of position control in the CNC. `v_command` is the position controller's output.
#[portable]
pub fn manipulate<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    let v_drive = if coeffs.adds { outputs.v_command + inputs.v_add } else { outputs.v_command };
    let increments = coeffs.manipulated_scale * v_drive;
    outputs.manipulated_variable = rounded(outputs, &coeffs.manipulated_range, increments);
}

/// The position command of position control in the drive.
#[portable]
pub fn lead<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    if !state.preset {
        delay::preset(&mut state.shift, inputs.x_command);
    }
    state.preset = true;
    let mut shifted = delay::Delayed::<R>::default();
    delay::step(&mut state.shift, &coeffs.shift, inputs.x_command, &mut shifted);
    if shifted.overwritten {
        // The present command is used instead; the next cycle refills the delay.
        state.preset = false;
        outputs.fault = true;
        outputs.error_id = error_state();
    }
    let x = if coeffs.feedforward { shifted.y + coeffs.lag * inputs.v_feedforward } else { shifted.y };
    outputs.x_drive = x;
    state.x_held = x;
    state.x_held_copy = x;
    if coeffs.location == Location::Profidrive {
        let deviation = coeffs.xerr_scale * (x - inputs.x_actual);
        outputs.xerr = rounded(outputs, &coeffs.xerr_range, deviation);
    } else {
        outputs.xerr = 0i32;
    }
}

/// The additive velocity of the feedforward, plus that of improved position control if the drive controls the position.
#[portable]
pub fn add_velocity<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    let adds = coeffs.adds && coeffs.location != Location::Cnc;
    if coeffs.additive || adds {
        let mut v_drive = empty_sum();
        if coeffs.additive {
            v_drive = v_drive + inputs.v_additive;
        }
        if adds {
            v_drive = v_drive + inputs.v_add;
        }
        let increments = coeffs.velocity_scale * v_drive;
        outputs.additive_velocity = rounded(outputs, &coeffs.velocity_range, increments);
    } else {
        outputs.additive_velocity = 0i32;
    }
}

/// The steps after the position controller. `outputs.v_command` already holds the controller's output.
#[portable]
pub fn put_out<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    outputs.limited = false;
    outputs.fault = false;
    outputs.error_id = error_none();
    if coeffs.location == Location::Cnc {
        outputs.x_drive = R::ZERO;
        outputs.xerr = 0i32;
        manipulate(coeffs, inputs, outputs);
        state.preset = true;
    } else {
        outputs.manipulated_variable = 0i32;
        lead(state, coeffs, inputs, outputs);
    }
    add_velocity(coeffs, inputs, outputs);
    outputs.additive_torque = if coeffs.torque { inputs.torque_feedforward } else { 0i32 };
}

/// One cycle. Only the inputs that the axis uses are checked.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    if coeffs.call_rate.active {
        let has_paused = call_rate::step(&mut state.call_rate, inputs.cycle_counter);
        if has_paused {
            state.preset = false;
        }
    }
    if !is_command_in_range(coeffs, inputs.x_command) {
        hold(state, coeffs, outputs, error_x_command());
    } else if inputs.task_cycle_ns != 0u32 && inputs.task_cycle_ns != coeffs.cycle_time_ns {
        follow(state, coeffs, inputs, outputs, error_cycle_time());
    } else if call_rate::is_wrong(&state.call_rate, &coeffs.call_rate) {
        follow(state, coeffs, inputs, outputs, error_call_rate());
    } else if !is_actual_in_range(coeffs, inputs.x_actual, inputs.following_error) {
        follow(state, coeffs, inputs, outputs, error_of_actual(coeffs));
    } else if coeffs.feedforward && !in_range(inputs.v_feedforward, sample_limit()) {
        follow(state, coeffs, inputs, outputs, error_v_feedforward());
    } else if coeffs.additive && !in_range(inputs.v_additive, sample_limit()) {
        follow(state, coeffs, inputs, outputs, error_v_additive());
    } else if coeffs.adds && !in_range(inputs.v_add, sample_limit()) {
        follow(state, coeffs, inputs, outputs, error_v_add());
    } else if !inputs.position_controlled || inputs.reset {
        follow(state, coeffs, inputs, outputs, error_none());
    } else {
        outputs.v_command = command(coeffs, inputs);
        put_out(state, coeffs, inputs, outputs);
    }
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct PositionControl;

impl<R: Real> Block<R> for PositionControl {
    types_init_and_step!(R, State<R>);

    const NAME: &'static str = "position_control";

    fn enable(_: &Coeffs<R>) -> Option<Enable> {
        Some(Enable { input: "position_controlled", off: Off::False })
    }

    fn inputs(_: &Coeffs<R>) -> Inputs<R> {
        Inputs { position_controlled: true, ..Inputs::default() }
    }

    fn exercise(inputs: &mut Inputs<R>, _: &Coeffs<R>) {
        inputs.torque_feedforward = 321;
    }
}
