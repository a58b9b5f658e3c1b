//! The whole axis of a spindle with parameter sets: the block `spindle_axis` of an axis with `tunable = "all"` or `"parameters"`. The
//! cycle is that of [`crate::spindle_axis`]; [`crate::sets`] says which set is in use.

use crate::ipc::STAGES;
use crate::ipc::numbers::Params;
use crate::sets;
use crate::signal::error_none;
use crate::spindle::{Job, SpindleState};
use crate::{axis, ipc, spindle, spindle_axis};
use portable::{Block, Enable, Real, copy, portable, with_numbers};

spindle_axis::inputs! {
    /// the parameter set
    pub params: Params<R>,
}

spindle_axis::outputs! {
    /// number of the parameter set in use; 0: none
    pub active_set: u32,
}

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// which sets fit
    pub sets: sets::Coeffs<R>,
    /// the spindle, with the numbers of the set that it was generated with
    pub spindle_axis: spindle_axis::Coeffs<R>,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// the set in use, and the one that is offered
    pub own: sets::State<R>,
    /// the cycle
    pub spindle_axis: spindle_axis::State<R>,
}

/// Before the first cycle: no set is in use.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    sets::drop_set(&mut state.own);
    spindle_axis::init(&mut state.spindle_axis);
}

/// Copies the inputs of the cycle, which runs in another mode while no set is in use.
#[portable]
pub fn hand_over<R: Real>(inputs: &Inputs<R>, mode: i32, spindle_inputs: &mut spindle_axis::Inputs<R>) {
    copy!(spindle_inputs = inputs:
        x_command, x_actual, v_interpolator, a_interpolator, j_interpolator, v_actual, v_motor, v_direct, s_word,
        s_position, m3, m4, m5, m19, putax, g74, job_done, drive_on, operation_mode_display, feedforward_active,
        feedforward_percentage, reset, task_cycle_ns, cycle_counter);
    spindle_inputs.mode = mode;
}

/// Writes the outputs of the cycle; `refused`: the reason if an offered set is refused, which is a fault while no set is in use.
#[portable]
pub fn put_out<R: Real>(
    set_id: u32,
    spindle_outputs: &spindle_axis::Outputs<R>,
    refused: u32,
    outputs: &mut Outputs<R>,
) {
    copy!(outputs = spindle_outputs:
        x_spindle, v_spindle, job_speed, job_position, v_command, v_feedforward, v_add, v_add_calculated, x_drive,
        spindle_state, job, job_number, waiting, operation_mode, velocity_command, manipulated_variable,
        additive_torque, additive_velocity, error_id, loop_closed, limited, held, tripped, fault);
    if refused != error_none() && !spindle_outputs.fault {
        outputs.fault = set_id == 0u32;
        outputs.error_id = refused;
    }
    outputs.active_set = set_id;
}

/// One cycle. Changeover and position control do not depend on the set.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    sets::compare_one(&mut state.own, &mut state.spindle_axis.axis.ipc, &coeffs.sets);
    let refused = sets::prepare(&mut state.own, &mut state.spindle_axis.axis.ipc, &coeffs.sets, &inputs.params);
    let mode = sets::acting_mode(&state.own, inputs.mode);
    let mut spindle_inputs = spindle_axis::Inputs::<R>::default();
    hand_over(inputs, mode, &mut spindle_inputs);
    let mut spindle_outputs = spindle_axis::Outputs::<R>::default();
    // The watch stays tripped until the caller's own mode is not ON.
    ipc::rearm(&mut state.spindle_axis.axis.ipc, &coeffs.spindle_axis.axis.ipc, inputs.mode, inputs.reset);
    spindle_axis::go_on(
        &mut state.spindle_axis,
        &spindle_axis::Coeffs {
            axis: axis::Coeffs {
                ipc: with_numbers(&coeffs.spindle_axis.axis.ipc, &state.own.now),
                ..coeffs.spindle_axis.axis
            },
            ..coeffs.spindle_axis
        },
        &spindle_inputs,
        &mut spindle_outputs,
    );
    put_out(state.own.set_id, &spindle_outputs, refused, outputs);
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct TunableSpindleAxis;

impl<R: Real> Block<R> for TunableSpindleAxis {
    types_init_and_step!(R, State<R>);

    const NAME: &'static str = <spindle_axis::SpindleAxis as Block<R>>::NAME;
    const SET: Option<&'static str> = Some("params");

    fn enable(coeffs: &Coeffs<R>) -> Option<Enable> {
        Some(spindle::enable(coeffs.spindle_axis.spindle.only_velocity))
    }

    fn inputs(coeffs: &Coeffs<R>) -> Inputs<R> {
        Inputs {
            mode: coeffs.spindle_axis.axis.ipc.enable,
            feedforward_percentage: 100,
            params: sets::params(&coeffs.sets),
            ..Inputs::default()
        }
    }

    fn exercise(inputs: &mut Inputs<R>, coeffs: &Coeffs<R>) {
        inputs.mode = ipc::mode_on();
        inputs.feedforward_active = true;
        inputs.feedforward_percentage = 87;
        inputs.drive_on = true;
        inputs.operation_mode_display = coeffs.spindle_axis.spindle.position_mode;
    }
}
