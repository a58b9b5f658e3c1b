//! The whole axis: feedforward, position control and improved position control, in the order in which they need each other.
//!
//! ```text
//! feedforward      v_interpolator, a, j                -> v_feedforward, v_additive, additive_torque
//! position control x_command, x_actual, v_feedforward  -> v_command
//! ipc              v_command, v_motor, v_direct        -> v_add          (a gantry slave: v_add_master)
//! position control v_command, v_add, v_additive        -> what the drive gets
//! ```
//!
//! Each part is the block of that name. Parts that the axis does not have are left out.

#![expect(clippy::field_reassign_with_default, reason = "portable Rust makes a struct by its default alone")]

mod signals;

pub use signals::{Inputs, Outputs};
pub(crate) use signals::{inputs, outputs};

use crate::signal::{
    error_call_rate, error_cycle_time, error_half_turn, error_none, error_unstable, error_v_add_master,
    error_v_interpolator, error_x_command, sample_limit,
};
use crate::{call_rate, feedforward, ipc, position_control, sets};
use portable::{Block, Enable, Off, Real, copy, in_range, note, portable, within};
use position_control::Location;

/// Where the additive velocity comes from.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Addition {
    /// no additive velocity
    #[default]
    None,
    /// from improved position control
    Ipc,
    /// from improved position control whose numbers come from parameter sets
    Sets,
    /// from the master of a gantry
    Master,
}

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// cycle time that all coefficients were designed for [ns]
    pub cycle_time_ns: u32,
    /// where the additive velocity comes from
    pub addition: Addition,
    /// whether there is feedforward
    pub has_feedforward: bool,
    /// TRUE: the drive of a spindle controls the position; it cannot distinguish the direction at half a turn per cycle
    pub counts_turns: bool,
    /// largest velocity below 180 deg / T [0.001 deg/s]
    pub v_largest: R,
    /// with parameter sets: largest |v_add| of any set [um/s or 0.001 deg/s]
    pub largest_v_add: R,
    /// gantry slave: largest |v_add| of the master [um/s or 0.001 deg/s]
    pub master_limit: R,
    /// -master_limit [um/s or 0.001 deg/s]
    pub master_lower_limit: R,
    /// feedforward
    pub feedforward: feedforward::Coeffs<R>,
    /// improved position control
    pub ipc: ipc::Coeffs<R>,
    /// position control
    pub position_control: position_control::Coeffs<R>,
    /// the call rate, which only the axis checks
    pub call_rate: call_rate::Coeffs,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// feedforward
    pub feedforward: feedforward::State<R>,
    /// improved position control
    pub ipc: ipc::State<R>,
    /// position control
    pub position_control: position_control::State<R>,
    /// the rate of the calls
    pub call_rate: call_rate::State,
}

/// Before the first cycle.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    feedforward::init(&mut state.feedforward);
    ipc::init(&mut state.ipc);
    position_control::init(&mut state.position_control);
    call_rate::init(&mut state.call_rate);
}

/// A cycle in which the axis must not act: afterwards every part restarts. What the caller tunes is not read then, and its last
/// values may be old: they are 0 until the axis acts on valid ones.
#[portable]
pub fn rest<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    outputs: &mut Outputs<R>,
    control_outputs: &position_control::Outputs<R>,
) {
    let mut feedforward_outputs = feedforward::Outputs::<R>::default();
    feedforward::stop(&mut state.feedforward, &mut feedforward_outputs, error_none());
    ipc::stop(&mut state.ipc);
    if coeffs.ipc.tuning.active {
        ipc::tuning::init(&mut state.ipc.tuning);
    }
    outputs.v_feedforward = R::ZERO;
    outputs.v_add = R::ZERO;
    outputs.v_add_calculated = R::ZERO;
    take(outputs, control_outputs);
    outputs.limited = false;
    outputs.held = false;
    copy!(outputs = control_outputs: fault, error_id);
}

/// Copies the outputs for the drive.
#[portable]
pub fn take<R: Real>(outputs: &mut Outputs<R>, control_outputs: &position_control::Outputs<R>) {
    copy!(outputs = control_outputs:
        v_command, manipulated_variable, x_drive, xerr, additive_velocity, additive_torque);
}

/// Feedforward, if the axis has it.
#[portable]
pub fn feed_forward<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    outputs: &mut Outputs<R>,
    feedforward_outputs: &mut feedforward::Outputs<R>,
) {
    if coeffs.has_feedforward {
        let mut feedforward_inputs = feedforward::Inputs::<R>::default();
        copy!(feedforward_inputs = inputs:
            v_interpolator, a_interpolator, j_interpolator, feedforward_active, feedforward_percentage);
        feedforward_inputs.position_controlled = true;
        feedforward::step(&mut state.feedforward, &coeffs.feedforward, &feedforward_inputs, feedforward_outputs);
        if feedforward_outputs.fault {
            fail(outputs, feedforward_outputs.error_id);
        }
        if feedforward_outputs.torque_limited {
            outputs.limited = true;
        }
    }
}

/// A fault of a part. Of several faults the one of the last part is reported.
#[portable]
pub fn fail<R: Real>(outputs: &mut Outputs<R>, error_id: u32) {
    outputs.fault = true;
    outputs.error_id = error_id;
}

/// The master's additive velocity within the master's limit; 0 if the sample is out of range.
#[portable]
pub fn follow_master<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) -> R {
    let mut v_followed = R::ZERO;
    if !in_range(inputs.v_add_master, sample_limit()) {
        fail(outputs, error_v_add_master());
    } else if within(inputs.v_add_master, coeffs.master_limit) {
        v_followed = inputs.v_add_master;
    } else {
        v_followed = if inputs.v_add_master > R::ZERO { coeffs.master_limit } else { coeffs.master_lower_limit };
        outputs.limited = true;
    }
    outputs.v_add = v_followed;
    outputs.v_add_calculated = v_followed;
    v_followed
}

/// The additive velocity of improved position control; 0 at once if the position loop is open.
#[portable]
pub fn improve<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    outputs: &mut Outputs<R>,
    v_command: R,
    loop_closed: bool,
) -> R {
    let mut ipc_inputs = ipc::Inputs::<R>::default();
    // Where the drive has the position controller, the interpolator's velocity is the command (P-AXIS-00753).
    ipc_inputs.v_command =
        if coeffs.position_control.location == Location::Cnc { v_command } else { inputs.v_interpolator };
    copy!(ipc_inputs = inputs: v_motor, v_direct, tuning_weight, tuning_limit, mode);
    ipc_inputs.position_controlled = loop_closed;
    let mut ipc_outputs = ipc::Outputs::<R>::default();
    ipc::go_on(&mut state.ipc, &coeffs.ipc, &ipc_inputs, &mut ipc_outputs);
    if coeffs.addition == Addition::Sets {
        sets::hold_limit(&mut state.ipc, &coeffs.ipc, coeffs.largest_v_add, &mut ipc_outputs);
    }
    if ipc_outputs.fault {
        fail(outputs, ipc_outputs.error_id);
    } else if coeffs.ipc.tuning.active && ipc_outputs.error_id != error_none() && !outputs.fault {
        note("not a fault: a tuning input is invalid, its last valid value stays active");
        outputs.error_id = ipc_outputs.error_id;
    }
    if ipc_outputs.limited {
        outputs.limited = true;
    }
    copy!(outputs = ipc_outputs: held, v_add, v_add_calculated);
    ipc_outputs.v_add
}

/// The additive velocity: of improved position control, or of the gantry's master.
#[portable]
pub fn add<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    outputs: &mut Outputs<R>,
    v_command: R,
    loop_closed: bool,
) -> R {
    match coeffs.addition {
        Addition::None => R::ZERO,
        Addition::Master => follow_master(coeffs, inputs, outputs),
        Addition::Ipc | Addition::Sets => improve(state, coeffs, inputs, outputs, v_command, loop_closed),
    }
}

/// Whether the axis has improved position control of its own.
#[portable]
pub fn improves<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.addition == Addition::Ipc || coeffs.addition == Addition::Sets
}

/// Whether the drive gets an additive velocity.
#[portable]
pub fn has_additive_velocity<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.position_control.additive
        || coeffs.position_control.adds && coeffs.position_control.location != Location::Cnc
}

/// Sets the outputs to their usual values, and to 0 those that the axis does not have; a part overwrites them if its result
/// differs. In the order of the outputs, so that a compiler can clear them together.
#[portable]
pub fn clear<R: Real>(outputs: &mut Outputs<R>, coeffs: &Coeffs<R>) {
    if coeffs.position_control.location != Location::Cnc {
        outputs.v_command = R::ZERO;
    }
    if !coeffs.position_control.feedforward {
        outputs.v_feedforward = R::ZERO;
    }
    if coeffs.addition == Addition::None {
        outputs.v_add = R::ZERO;
        outputs.v_add_calculated = R::ZERO;
    }
    if coeffs.position_control.location != Location::Cnc {
        outputs.manipulated_variable = 0i32;
    }
    if coeffs.position_control.location == Location::Cnc {
        outputs.x_drive = R::ZERO;
    }
    if coeffs.position_control.location != Location::Profidrive {
        outputs.xerr = 0i32;
    }
    if !coeffs.position_control.torque {
        outputs.additive_torque = 0i32;
    }
    if !has_additive_velocity(coeffs) {
        outputs.additive_velocity = 0i32;
    }
    outputs.error_id = error_none();
    outputs.limited = false;
    outputs.held = false;
    outputs.fault = false;
}

/// A cycle in which the axis acts. Improved position control acts only if the position loop is closed. Returns the additive
/// velocity of the feedforward.
#[portable]
pub fn act<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    outputs: &mut Outputs<R>,
    loop_closed: bool,
) -> R {
    clear(outputs, coeffs);
    let mut control_inputs = position_control::Inputs::<R>::default();
    copy!(control_inputs = inputs: x_command, x_actual, following_error);
    let mut feedforward_outputs = feedforward::Outputs::<R>::default();
    feed_forward(state, coeffs, inputs, outputs, &mut feedforward_outputs);
    if coeffs.position_control.feedforward {
        outputs.v_feedforward = feedforward_outputs.v_feedforward;
    }
    copy!(control_inputs = feedforward_outputs: v_feedforward, v_additive);
    control_inputs.torque_feedforward = feedforward_outputs.additive_torque;
    let mut control_outputs = position_control::Outputs::<R>::default();
    control_outputs.v_command = position_control::command(&coeffs.position_control, &control_inputs);
    control_inputs.v_add = add(state, coeffs, inputs, outputs, control_outputs.v_command, loop_closed);
    position_control::put_out(
        &mut state.position_control,
        &coeffs.position_control,
        &control_inputs,
        &mut control_outputs,
    );
    if coeffs.position_control.location == Location::Cnc {
        copy!(outputs = control_outputs: v_command, manipulated_variable);
    } else {
        outputs.x_drive = control_outputs.x_drive;
    }
    if coeffs.position_control.location == Location::Profidrive {
        outputs.xerr = control_outputs.xerr;
    }
    if has_additive_velocity(coeffs) {
        outputs.additive_velocity = control_outputs.additive_velocity;
    }
    if coeffs.position_control.torque {
        outputs.additive_torque = control_outputs.additive_torque;
    }
    if control_outputs.limited {
        outputs.limited = true;
    }
    if control_outputs.fault {
        fail(outputs, control_outputs.error_id);
    }
    tell_trip(state, coeffs, outputs);
    feedforward_outputs.v_additive
}

/// A cycle in which the axis must not act, with a command position in range.
#[portable]
pub fn follow<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    outputs: &mut Outputs<R>,
    error_id: u32,
) {
    let mut control_inputs = position_control::Inputs::<R>::default();
    control_inputs.x_command = inputs.x_command;
    let mut control_outputs = position_control::Outputs::<R>::default();
    position_control::follow(
        &mut state.position_control,
        &coeffs.position_control,
        &control_inputs,
        &mut control_outputs,
        error_id,
    );
    rest(state, coeffs, outputs, &control_outputs);
    tell_trip(state, coeffs, outputs);
}

/// A cycle without a command position in range.
#[portable]
pub fn hold<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>, error_id: u32) {
    let mut control_outputs = position_control::Outputs::<R>::default();
    position_control::hold(&mut state.position_control, &coeffs.position_control, &mut control_outputs, error_id);
    rest(state, coeffs, outputs, &control_outputs);
    tell_trip(state, coeffs, outputs);
}

/// Checks the call rate. After a pause every part restarts.
#[portable]
pub fn count_call<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, cycle_counter: u32) {
    if coeffs.call_rate.active {
        let has_paused = call_rate::step(&mut state.call_rate, cycle_counter);
        if has_paused {
            state.feedforward.preset = false;
            state.position_control.preset = false;
            ipc::stop(&mut state.ipc);
        }
    }
}

/// Reports whether the watch has tripped; its id is shown only if there is no fault.
#[portable]
pub fn tell_trip<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>) {
    outputs.tripped = coeffs.ipc.watch.active && state.ipc.watch.tripped;
    if coeffs.ipc.watch.active && state.ipc.watch.tripped && !outputs.fault {
        outputs.error_id = error_unstable();
    }
}

/// One cycle. Only the inputs that the axis uses are checked.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    ipc::rearm(&mut state.ipc, &coeffs.ipc, inputs.mode, inputs.reset);
    go_on(state, coeffs, inputs, outputs);
}

/// The rest of the cycle, after the watch has been rearmed.
#[portable]
pub fn go_on<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    count_call(state, coeffs, inputs.cycle_counter);
    if !position_control::is_command_in_range(&coeffs.position_control, inputs.x_command) {
        hold(state, coeffs, outputs, error_x_command());
    } else if inputs.task_cycle_ns != 0u32 && inputs.task_cycle_ns != coeffs.cycle_time_ns {
        follow(state, coeffs, inputs, outputs, error_cycle_time());
    } else if call_rate::is_wrong(&state.call_rate, &coeffs.call_rate) {
        follow(state, coeffs, inputs, outputs, error_call_rate());
    } else if !position_control::is_actual_in_range(&coeffs.position_control, inputs.x_actual, inputs.following_error) {
        follow(state, coeffs, inputs, outputs, position_control::error_of_actual(&coeffs.position_control));
    } else if !inputs.position_controlled || inputs.reset {
        follow(state, coeffs, inputs, outputs, error_none());
    } else if coeffs.counts_turns
        && in_range(inputs.v_interpolator, sample_limit())
        && !in_range(inputs.v_interpolator, coeffs.v_largest)
    {
        hold(state, coeffs, outputs, error_half_turn());
    } else {
        act(state, coeffs, inputs, outputs, true);
        if coeffs.counts_turns && !in_range(inputs.v_interpolator, sample_limit()) {
            note("the position command needs no velocity: it goes on");
            fail(outputs, error_v_interpolator());
        }
    }
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct Axis;

impl<R: Real> Block<R> for Axis {
    types_init_and_step!(R, State<R>);

    const NAME: &'static str = "axis";
    const FRACTIONS: &'static [&'static str] = ipc::tuning::INPUTS;

    fn enable(_: &Coeffs<R>) -> Option<Enable> {
        Some(Enable { input: "position_controlled", off: Off::False })
    }

    fn inputs(coeffs: &Coeffs<R>) -> Inputs<R> {
        Inputs {
            mode: coeffs.ipc.enable,
            feedforward_percentage: 100,
            position_controlled: true,
            tuning_weight: coeffs.ipc.tuning.weight,
            tuning_limit: coeffs.ipc.tuning.limit,
            ..Inputs::default()
        }
    }

    fn exercise(inputs: &mut Inputs<R>, _: &Coeffs<R>) {
        inputs.mode = ipc::mode_on();
        (inputs.tuning_weight, inputs.tuning_limit) = ([R::ONE; ipc::STAGES], R::ONE);
        inputs.feedforward_active = true;
        inputs.feedforward_percentage = 87;
    }
}
