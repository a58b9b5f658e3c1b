//! Excitation: a maximum-length sequence on the commanded velocity, from which the response of a drive is measured.
//!
//! ```text
//! s         = 1 or -1: a shift register of n bits, all ones at the start; 2^n - 1 clocks are a period
//! v_excite  = amplitude * fade * s
//! v_cmd     = v_command + v_add + v_excite
//! ```
//!
//! A clock puts out the last bit of the register, 1 as +1 and 0 as -1, then shifts the exclusive-or of the tapped bits in at the
//! front. The fade rises from 0 to 1 at the start and falls alike at the end. One period settles, the others are measured.
//!
//! The rising edge of `hold_to_run` starts the excitation, FALSE ends it through the fade, and so does a change of the sign of
//! `v_motor`: friction would act as an excitation of its own. A fault and the loss of position control end it at once. Each start
//! needs a rising edge.

use crate::call_rate;
use crate::signal::sample_limit;
use crate::signal::{error_call_rate, error_cycle_time, error_none, error_reversal, error_state, error_v_motor};
use portable::{Block, Enable, Off, Real, from_u32, in_range, note, portable};

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// cycle time that all coefficients were designed for [ns]
    pub cycle_time_ns: u32,
    /// bits of the shift register n
    pub bits: u32,
    /// clocks of a period 2^n - 1; as a register: all bits are 1
    pub ones: u32,
    /// front bit of the register as a number, 2^(n - 1)
    pub front: u32,
    /// cycles of a clock c
    pub clock: u32,
    /// periods that are measured M, after one that settles
    pub periods: u32,
    /// amplitude A
    pub amplitude: R,
    /// length of the fade from 0 to 1 [cycles]
    pub fade_cycles: u32,
    /// amplitude / fade_cycles
    pub fade_step: R,
    /// the rate of the calls
    pub call_rate: call_rate::Coeffs,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State {
    /// hold_to_run of the previous cycle; TRUE before the first one, so that a button that is held then starts nothing
    pub held: bool,
    /// TRUE from the start until the excitation has faded out
    pub active: bool,
    /// TRUE while it fades out
    pub ends: bool,
    /// TRUE after all periods have been measured
    pub complete: bool,
    /// TRUE after the motor has changed its direction, until the next start
    pub reversed: bool,
    /// whether the motor moved in positive direction at the start
    pub forward: bool,
    /// position of the fade [cycles]: 0 off, fade_cycles full
    pub fade: u32,
    /// the shift register, the last bit is its remainder by 2; 0: no excitation is active
    pub register: u32,
    /// the cycle of the clock, from 1
    pub cycle: u32,
    /// the clock of the period, from 1
    pub clock: u32,
    /// the period: 0 settles
    pub period: u32,
    /// the rate of the calls
    pub call_rate: call_rate::State,
}

/// Inputs. Translatory axes in um, rotary axes and spindles in 0.001 deg.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Inputs<R> {
    /// actual velocity of the motor: it must keep its sign [um/s or 0.001 deg/s]
    pub v_motor: R,
    /// hold-to-run button: its rising edge starts the excitation, which runs while it is TRUE; FALSE fades it out
    pub hold_to_run: bool,
    /// FALSE: the axis is not in position control, or has a fault: v_excite is 0 at once; a button that is still held when it
    /// is TRUE again starts nothing
    pub position_controlled: bool,
    /// cycle time of the calling task [ns]; 0: unchecked; a value other than the designed cycle time is a fault
    pub task_cycle_ns: u32,
    /// with the key cycle_counter: cycle counter of the controller; 0: unchecked, in TwinCAT the counter of the task is used;
    /// skipped and doubled calls are a fault; a pause ends the excitation
    pub cycle_counter: u32,
}

/// Outputs.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Outputs<R> {
    /// what is added to the commanded velocity: v_command + v_add + v_excite [um/s or 0.001 deg/s]
    pub v_excite: R,
    /// TRUE from the start until v_excite has faded out
    pub active: bool,
    /// all periods have been measured, and v_excite has faded out; until the next start or fault
    pub done: bool,
    /// the measured period of this cycle, from 1; 0: the excitation settles, fades out or is not active
    pub period: u32,
    /// the block cannot act in this cycle, and the excitation has ended at once; the error id gives the reason
    pub fault: bool,
    /// reason of the fault, or of the end by a change of direction: 0 none
    pub error_id: u32,
}

/// No excitation: the next one needs a rising edge.
#[portable]
pub fn stop(state: &mut State) {
    state.active = false;
    state.ends = false;
    state.fade = 0u32;
    state.register = 0u32;
    state.cycle = 1u32;
    state.clock = 1u32;
    state.period = 0u32;
}

/// No excitation, and nothing to report of the last one.
#[portable]
pub fn forget(state: &mut State) {
    stop(state);
    state.complete = false;
    state.reversed = false;
}

/// Before the first cycle.
#[portable]
pub fn init(state: &mut State) {
    state.held = true;
    state.forward = false;
    forget(state);
    call_rate::init(&mut state.call_rate);
}

/// The exclusive-or of the tapped bits, 0 or 1. A tap, counted from the front, is the digit n - tap of the register in binary.
#[portable]
pub fn fed<R: Real>(coeffs: &Coeffs<R>, register: u32) -> u32 {
    let last = register % 2u32;
    let sum = match coeffs.bits {
        8u32 => last + register / 4u32 % 2u32 + register / 8u32 % 2u32 + register / 16u32 % 2u32,
        9u32 => last + register / 16u32 % 2u32,
        10u32 => last + register / 8u32 % 2u32,
        11u32 => last + register / 4u32 % 2u32,
        12u32 => last + register / 2u32 % 2u32 + register / 4u32 % 2u32 + register / 256u32 % 2u32,
        13u32 => last + register / 2u32 % 2u32 + register / 4u32 % 2u32 + register / 32u32 % 2u32,
        14u32 => last + register / 2u32 % 2u32 + register / 4u32 % 2u32 + register / 4096u32 % 2u32,
        _ => last + register / 2u32 % 2u32,
    };
    sum % 2u32
}

/// Whether the state of an active excitation is possible; a state of an excitation that is not active is not looked at.
#[portable]
pub fn is_sound<R: Real>(state: &State, coeffs: &Coeffs<R>) -> bool {
    !state.active
        || state.fade <= coeffs.fade_cycles
            && state.register > 0u32
            && state.register <= coeffs.ones
            && state.cycle <= coeffs.clock
            && state.clock <= coeffs.ones
            && state.period <= coeffs.periods
}

/// Starts at the first clock of the period that settles, or refuses to: the motor stands still.
#[portable]
pub fn start<R: Real>(state: &mut State, coeffs: &Coeffs<R>, v_motor: R) {
    forget(state);
    let forward = v_motor > R::ZERO;
    let backward = v_motor < R::ZERO;
    if forward || backward {
        state.forward = forward;
        state.register = coeffs.ones;
        state.active = true;
    } else {
        state.reversed = true;
    }
}

/// Whether the motor does not move in the direction of the start.
#[portable]
pub fn is_reversed<R: Real>(forward: bool, v_motor: R) -> bool {
    if forward { v_motor <= R::ZERO } else { v_motor >= R::ZERO }
}

/// The next clock; after the last one of a period the next period, after the last period the end.
#[portable]
pub fn shift<R: Real>(state: &mut State, coeffs: &Coeffs<R>) {
    let next = fed(coeffs, state.register);
    state.register = if next > 0u32 { state.register / 2u32 + coeffs.front } else { state.register / 2u32 };
    if state.clock < coeffs.ones {
        state.clock += 1u32;
    } else {
        state.clock = 1u32;
        if state.register != coeffs.ones {
            note("the register was corrupted: the next cycle reports the fault");
            state.register = 0u32;
        }
        if state.period < coeffs.periods {
            if !state.ends {
                state.period += 1u32;
            }
        } else if !state.ends {
            state.complete = true;
            state.ends = true;
        }
    }
}

/// Moves the fade by one cycle; the excitation ends when it has faded out.
#[portable]
pub fn move_fade<R: Real>(state: &mut State, coeffs: &Coeffs<R>) {
    if state.ends {
        if state.fade > 1u32 {
            state.fade -= 1u32;
        } else {
            stop(state);
        }
    } else if state.fade < coeffs.fade_cycles {
        state.fade += 1u32;
    }
}

/// A cycle of an active excitation.
#[portable]
pub fn excite<R: Real>(state: &mut State, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>) {
    outputs.active = true;
    outputs.done = false;
    outputs.period = if state.ends { 0u32 } else { state.period };
    let level =
        if state.fade < coeffs.fade_cycles { from_u32::<R>(state.fade) * coeffs.fade_step } else { coeffs.amplitude };
    let last = state.register % 2u32;
    outputs.v_excite = if last == 1u32 { level } else { -level };
    let ends = state.ends;
    if state.cycle < coeffs.clock {
        state.cycle += 1u32;
    } else {
        state.cycle = 1u32;
        shift(state, coeffs);
    }
    // The fade falls from the first cycle after the last period.
    if ends == state.ends {
        move_fade(state, coeffs);
    }
}

/// A cycle without excitation.
#[portable]
pub fn rest<R: Real>(state: &State, outputs: &mut Outputs<R>) {
    outputs.v_excite = R::ZERO;
    outputs.active = false;
    outputs.done = state.complete;
    outputs.period = 0u32;
}

/// A cycle with a fault: the excitation has ended.
#[portable]
pub fn refuse<R: Real>(state: &mut State, outputs: &mut Outputs<R>, error_id: u32) {
    forget(state);
    rest(state, outputs);
    outputs.fault = true;
    outputs.error_id = error_id;
}

/// A cycle without a fault. `rises`: the button was pressed.
#[portable]
pub fn act<R: Real>(state: &mut State, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>, rises: bool) {
    if !inputs.position_controlled {
        forget(state);
    } else if state.active {
        if !state.ends && is_reversed(state.forward, inputs.v_motor) {
            state.reversed = true;
            state.ends = true;
        }
        if !inputs.hold_to_run {
            state.ends = true;
        }
    } else if rises {
        start(state, coeffs, inputs.v_motor);
    }
    outputs.fault = false;
    outputs.error_id = if state.reversed { error_reversal() } else { error_none() };
    if state.active {
        excite(state, coeffs, outputs);
    } else {
        rest(state, outputs);
    }
}

/// One cycle.
#[portable]
pub fn step<R: Real>(state: &mut State, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    let rises = inputs.hold_to_run && !state.held;
    state.held = inputs.hold_to_run;
    if coeffs.call_rate.active {
        let has_paused = call_rate::step(&mut state.call_rate, inputs.cycle_counter);
        if has_paused {
            forget(state);
        }
    }
    let sound = is_sound(state, coeffs);
    if inputs.task_cycle_ns != 0u32 && inputs.task_cycle_ns != coeffs.cycle_time_ns {
        refuse(state, outputs, error_cycle_time());
    } else if call_rate::is_wrong(&state.call_rate, &coeffs.call_rate) {
        refuse(state, outputs, error_call_rate());
    } else if !in_range(inputs.v_motor, sample_limit()) {
        refuse(state, outputs, error_v_motor());
    } else if !sound {
        note("the state was corrupted");
        refuse(state, outputs, error_state());
    } else {
        act(state, coeffs, inputs, outputs, rises);
    }
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct Excitation;

impl<R: Real> Block<R> for Excitation {
    types_init_and_step!(R, State);

    const NAME: &'static str = "excitation";

    fn enable(_: &Coeffs<R>) -> Option<Enable> {
        Some(Enable { input: "position_controlled", off: Off::False })
    }

    fn inputs(_: &Coeffs<R>) -> Inputs<R> {
        Inputs { position_controlled: true, ..Inputs::default() }
    }

    fn exercise(inputs: &mut Inputs<R>, _: &Coeffs<R>) {
        inputs.hold_to_run = true;
    }
}
