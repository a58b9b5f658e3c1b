//! The whole axis with parameter sets: the block `axis` of an axis with `tunable = "all"` or `"parameters"`. The cycle is that of
//! [`crate::axis`]; [`crate::sets`] says which set is in use.

use crate::ipc::STAGES;
use crate::ipc::numbers::Params;
use crate::sets;
use crate::signal::error_none;
use crate::{axis, ipc};
use portable::{Block, Enable, Real, copy, portable, with_numbers};

axis::inputs! {
    /// the parameter set
    pub params: Params<R>,
}

axis::outputs! {
    /// number of the parameter set in use; 0: none
    pub active_set: u32,
}

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// which sets fit
    pub sets: sets::Coeffs<R>,
    /// the axis, with the numbers of the set that it was generated with
    pub axis: axis::Coeffs<R>,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// the set in use, and the one that is offered
    pub own: sets::State<R>,
    /// the cycle
    pub axis: axis::State<R>,
}

/// Before the first cycle: no set is in use.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    sets::drop_set(&mut state.own);
    axis::init(&mut state.axis);
}

/// Copies the inputs of the cycle, which runs in another mode while no set is in use.
#[portable]
pub fn hand_over<R: Real>(inputs: &Inputs<R>, mode: i32, axis_inputs: &mut axis::Inputs<R>) {
    copy!(axis_inputs = inputs:
        x_command, x_actual, following_error, v_interpolator, a_interpolator, j_interpolator, v_motor, v_direct,
        feedforward_active, feedforward_percentage, position_controlled, reset, task_cycle_ns, cycle_counter);
    axis_inputs.mode = mode;
}

/// Writes the outputs of the cycle; `refused`: the reason if an offered set is refused, which is a fault while no set is in use.
#[portable]
pub fn put_out<R: Real>(set_id: u32, axis_outputs: &axis::Outputs<R>, refused: u32, outputs: &mut Outputs<R>) {
    copy!(outputs = axis_outputs:
        v_command, v_feedforward, v_add, v_add_calculated, x_drive, manipulated_variable, xerr, additive_torque,
        additive_velocity, error_id, limited, held, tripped, fault);
    if refused != error_none() && !axis_outputs.fault {
        outputs.fault = set_id == 0u32;
        outputs.error_id = refused;
    }
    outputs.active_set = set_id;
}

/// One cycle. The position control does not depend on the set.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    sets::compare_one(&mut state.own, &mut state.axis.ipc, &coeffs.sets);
    let refused = sets::prepare(&mut state.own, &mut state.axis.ipc, &coeffs.sets, &inputs.params);
    let mode = sets::acting_mode(&state.own, inputs.mode);
    let mut axis_inputs = axis::Inputs::<R>::default();
    hand_over(inputs, mode, &mut axis_inputs);
    let mut axis_outputs = axis::Outputs::<R>::default();
    // The watch stays tripped until the caller's own mode is not ON.
    ipc::rearm(&mut state.axis.ipc, &coeffs.axis.ipc, inputs.mode, inputs.reset);
    axis::go_on(
        &mut state.axis,
        &axis::Coeffs { ipc: with_numbers(&coeffs.axis.ipc, &state.own.now), ..coeffs.axis },
        &axis_inputs,
        &mut axis_outputs,
    );
    put_out(state.own.set_id, &axis_outputs, refused, outputs);
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct TunableAxis;

impl<R: Real> Block<R> for TunableAxis {
    types_init_and_step!(R, State<R>);

    const NAME: &'static str = <axis::Axis as Block<R>>::NAME;
    const SET: Option<&'static str> = Some("params");

    fn enable(coeffs: &Coeffs<R>) -> Option<Enable> {
        <axis::Axis as Block<R>>::enable(&coeffs.axis)
    }

    fn inputs(coeffs: &Coeffs<R>) -> Inputs<R> {
        Inputs {
            mode: coeffs.axis.ipc.enable,
            feedforward_percentage: 100,
            position_controlled: true,
            params: sets::params(&coeffs.sets),
            ..Inputs::default()
        }
    }

    fn exercise(inputs: &mut Inputs<R>, _: &Coeffs<R>) {
        inputs.mode = ipc::mode_on();
        inputs.feedforward_active = true;
        inputs.feedforward_percentage = 87;
    }
}
