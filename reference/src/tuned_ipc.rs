//! Improved position control with parts that the caller tunes: the block `ipc` of an axis with `tunable = "weights"`. It does what
//! [`crate::ipc`] does, and begins with the usual cycle.

use crate::call_rate;
use crate::ipc::tuning::{self, are_followed};
use crate::ipc::{self, Coeffs, Inputs, Ipc, Outputs, State};
use portable::{Block, Enable, Fn, Real, portable};

/// One cycle. In a usual one the mode is ON, the fade full, and every part is what its input asks for: nothing but the sections changes.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    if ipc::may_act_in_full(coeffs, inputs)
        && call_rate::is_usual(&state.call_rate, &coeffs.call_rate, inputs.cycle_counter)
        && state.fade == coeffs.fade_cycles
        && !(coeffs.watch.active && state.watch.tripped)
        && (!coeffs.ride_through.active || state.ride_through.bad == 0u32)
        && are_followed(&state.tuning, &coeffs.tuning, &coeffs.stage, inputs)
    {
        outputs.held = false;
        call_rate::go_on(&mut state.call_rate, &coeffs.call_rate, inputs.cycle_counter);
        ipc::act_in_full(state, coeffs, inputs, outputs);
        ipc::tell_trip(state, coeffs, outputs);
    } else {
        ipc::step(state, coeffs, inputs, outputs);
    }
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct TunedIpc;

impl<R: Real> Block<R> for TunedIpc {
    type Coeffs = Coeffs<R>;
    type State = State<R>;
    type Inputs = Inputs<R>;
    type Outputs = Outputs<R>;

    const NAME: &'static str = <Ipc as Block<R>>::NAME;
    const ENABLE: Option<Enable> = <Ipc as Block<R>>::ENABLE;
    const USUAL_FIRST: bool = true;
    const FRACTIONS: &'static [&'static str] = tuning::INPUTS;
    const INIT: Fn = <Ipc as Block<R>>::INIT;
    const STEP: Fn = step::Ir::<R>::IR;

    fn memory() -> State<R> {
        <Ipc as Block<R>>::memory()
    }

    fn init(state: &mut State<R>) {
        <Ipc as Block<R>>::init(state);
    }

    fn inputs(coeffs: &Coeffs<R>) -> Inputs<R> {
        <Ipc as Block<R>>::inputs(coeffs)
    }

    fn exercise(inputs: &mut Inputs<R>, coeffs: &Coeffs<R>) {
        <Ipc as Block<R>>::exercise(inputs, coeffs);
    }

    fn outputs() -> Outputs<R> {
        <Ipc as Block<R>>::outputs()
    }

    fn step(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
        step(state, coeffs, inputs, outputs);
    }
}
