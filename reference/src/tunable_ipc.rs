//! Improved position control whose numbers come from parameter sets: the block `ipc` of an axis with `tunable = "all"`. The cycle is
//! that of [`crate::ipc`]; [`crate::sets`] says which set is in use.

pub use crate::sets::Coeffs;

use crate::call_rate;
use crate::ipc;
use crate::ipc::numbers::Params;
use crate::sets;
use crate::signal::error_none;
use portable::{Block, Enable, Off, Real, copy, note, portable, with_numbers};

ipc::inputs! { []
    /// the parameter set
    pub params: Params<R>,
}

ipc::outputs! { "the sum of the stages is above the limit of the parameter set in this cycle"
    /// number of the parameter set in use; 0: none
    pub active_set: u32,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// the set in use, and the one that is offered
    pub own: sets::State<R>,
    /// the cycle
    pub ipc: ipc::State<R>,
}

/// Before the first cycle: no set is in use.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    sets::drop_set(&mut state.own);
    ipc::init(&mut state.ipc);
}

/// Copies the inputs for the cycle of [`crate::ipc`].
#[portable]
pub fn hand_over<R: Real>(inputs: &Inputs<R>, mode: i32, ipc_inputs: &mut ipc::Inputs<R>) {
    copy!(ipc_inputs = inputs: v_command, v_motor, v_direct);
    ipc_inputs.mode = mode;
    copy!(ipc_inputs = inputs: position_controlled, reset, task_cycle_ns);
}

/// Writes the outputs of the cycle of [`crate::ipc`]; `refused`: the reason if an offered set is refused.
#[portable]
pub fn put_out<R: Real>(set_id: u32, ipc_outputs: &ipc::Outputs<R>, refused: u32, outputs: &mut Outputs<R>) {
    copy!(outputs = ipc_outputs: v_add, v_add_calculated, limited, held, tripped, fault, error_id);
    if refused != error_none() && !ipc_outputs.fault {
        outputs.fault = set_id == 0u32;
        outputs.error_id = refused;
    }
    outputs.active_set = set_id;
}

/// Any cycle.
#[portable]
pub fn any_cycle<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    ipc::count_call(&mut state.ipc, &coeffs.ipc, inputs.cycle_counter);
    let refused = sets::prepare(&mut state.own, &mut state.ipc, coeffs, &inputs.params);
    let mode = sets::acting_mode(&state.own, inputs.mode);
    let mut ipc_inputs = ipc::Inputs::<R>::default();
    hand_over(inputs, mode, &mut ipc_inputs);
    let mut ipc_outputs = ipc::Outputs::<R>::default();
    // The watch stays tripped until the caller's own mode is not ON.
    ipc::rearm(&mut state.ipc, &coeffs.ipc, inputs.mode, inputs.reset);
    ipc::go_on(&mut state.ipc, &with_numbers(&coeffs.ipc, &state.own.now), &ipc_inputs, &mut ipc_outputs);
    sets::hold_limit(&mut state.ipc, &coeffs.ipc, coeffs.ipc.limit, &mut ipc_outputs);
    put_out(state.own.set_id, &ipc_outputs, refused, outputs);
}

/// One cycle. It starts with the fast path: the set in use is the offered one, and only the sections change. It has the same
/// result as `any_cycle`, with fewer conditions.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    sets::compare_one(&mut state.own, &mut state.ipc, coeffs);
    let mut ipc_inputs = ipc::Inputs::<R>::default();
    hand_over(inputs, inputs.mode, &mut ipc_inputs);
    if inputs.params.set_id == state.own.acting_set
        && ipc::may_act_in_full(&coeffs.ipc, &ipc_inputs)
        && call_rate::is_usual(&state.ipc.call_rate, &coeffs.ipc.call_rate, inputs.cycle_counter)
        && state.ipc.fade == coeffs.ipc.fade_cycles
        && !(coeffs.ipc.watch.active && state.ipc.watch.tripped)
        && (!coeffs.ipc.ride_through.active || state.ipc.ride_through.bad == 0u32)
    {
        note("the fast path: the offered set is in use, the mode is ON, and the fade is full");
        let mut ipc_outputs = ipc::Outputs::<R>::default();
        call_rate::go_on(&mut state.ipc.call_rate, &coeffs.ipc.call_rate, inputs.cycle_counter);
        ipc::act_in_full(&mut state.ipc, &with_numbers(&coeffs.ipc, &state.own.now), &ipc_inputs, &mut ipc_outputs);
        ipc::tell_trip(&state.ipc, &coeffs.ipc, &mut ipc_outputs);
        sets::hold_limit(&mut state.ipc, &coeffs.ipc, coeffs.ipc.limit, &mut ipc_outputs);
        put_out(state.own.acting_set, &ipc_outputs, error_none(), outputs);
    } else {
        note("any other cycle: an offered set, the start, a fade, a fault");
        any_cycle(state, coeffs, inputs, outputs);
    }
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct TunableIpc;

impl<R: Real> Block<R> for TunableIpc {
    types_init_and_step!(R, State<R>);

    const NAME: &'static str = <ipc::Ipc as Block<R>>::NAME;
    const SET: Option<&'static str> = Some("params");

    fn enable(_: &Coeffs<R>) -> Option<Enable> {
        Some(Enable { input: "mode", off: Off::Mode(&ipc::mode_off::Ir::<R>::IR, "ipc.preset") })
    }

    fn is_usual_first(_: &Coeffs<R>) -> bool {
        true
    }

    fn inputs(coeffs: &Coeffs<R>) -> Inputs<R> {
        Inputs { mode: coeffs.ipc.enable, position_controlled: true, params: sets::params(coeffs), ..Inputs::default() }
    }

    fn exercise(inputs: &mut Inputs<R>, _: &Coeffs<R>) {
        inputs.mode = ipc::mode_on();
    }
}
