//! Improved position control whose numbers come from parameter sets: the block `ipc` of an axis with `tunable = "all"`.
//!
//! The cycle is that of [`crate::ipc`]. The structure (stages, modes, filters, cycle time) is fixed; the numbers are those of
//! the set in use, which is kept in the state. A set with another set number is offered, and is taken over through the fade:
//!
//! ```text
//! offered         checked, one piece of one number in a cycle; if refused, the set in use stays active
//! fade out        as in DRYRUN
//! fade at 0       copied in one cycle; no set is in use until the copied numbers have been checked again, piece by piece
//! fade in         as mode says; the sections start from the steady state of the present input
//! ```
//!
//! So no cycle costs more than the usual one and a bounded amount. The state holds the numbers in use twice and compares one of
//! them with its copy in each cycle. A difference is a corrupted state (error 3): then no set is in use until the offered one
//! has been checked and taken over again. The limit in the generated block applies to every set. What was copied is what is
//! checked and used: a set that another task writes meanwhile is refused. A refused set is checked again after fade_cycles
//! cycles, when another task has finished writing it. Until the first set is taken over v_add is 0, and a refused set is a
//! fault.

pub mod check;
mod signals;

pub use check::{numbers_of, params, refusal, seal};
pub use signals::{Inputs, Outputs};

use crate::call_rate;
use crate::ipc;
use crate::ipc::numbers::{self, Numbers, Params};
use crate::signal::{error_none, error_set_damaged, error_set_structure};
use crate::turn::Picked;
use portable::{Block, Enable, Off, Real, copy, in_range, note, portable, with_numbers};

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// id of the block structure: a parameter set for another structure is refused
    pub structure: u32,
    /// check word of the structure, before the first number of a set: its first part
    pub empty_first: i32,
    /// check word of the structure, before the first number of a set: its second part
    pub empty_second: i32,
    /// the number of the set that the block was generated with
    pub set_id: u32,
    /// the block, with the numbers of the set that it was generated with
    pub ipc: ipc::Coeffs<R>,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// number of the set in use; 0: none
    pub set_id: u32,
    /// number of the set in use while it acts; 0: the block fades out for another set, or no set is in use
    pub acting_set: u32,
    /// number of the set that is offered
    pub offered_set: u32,
    /// number of the set whose numbers were copied and are being checked again; 0: none
    pub copied_set: u32,
    /// cycles until a refused set is checked again
    pub pause: u32,
    /// error id of the last set that was refused
    pub refused: u32,
    /// number of the last set that was refused
    pub refused_set: u32,
    /// the numbers of the set in use
    pub now: Numbers<R>,
    /// copy of the numbers in use
    pub copy: Numbers<R>,
    /// cycle in the round of comparisons, from 0 on: it selects the number to compare with its copy
    pub turn: u32,
    /// the number in use whose turn it is
    pub picked: Picked<R>,
    /// the check of an offered set, or of the numbers that were copied
    pub check: check::State<R>,
    /// the cycle
    pub ipc: ipc::State<R>,
}

/// Length of a round of comparisons, as a multiple of the cycles that all comparisons take. In the others nothing is compared,
/// so that the mean cost of a cycle is small.
pub const ROUND: u32 = 4;

/// Whether the fade is on its way to 0, because of a set or of the watch.
#[portable]
pub fn is_leaving<R: Real>(state: &State<R>, coeffs: &Coeffs<R>) -> bool {
    state.ipc.fade > 0u32 && (state.acting_set == 0u32 || coeffs.ipc.watch.active && state.ipc.watch.tripped)
}

/// Whether the offered set is the one that was refused last. A corrupted state cannot produce an id that is not a refusal.
#[portable]
pub fn is_refused<R: Real>(state: &State<R>) -> bool {
    state.offered_set == state.refused_set
        && state.refused >= error_set_structure()
        && state.refused <= error_set_damaged()
}

/// Whether the offered set was refused a short time ago. A corrupted state cannot extend the pause.
#[portable]
pub fn is_paused<R: Real>(state: &State<R>, coeffs: &Coeffs<R>) -> bool {
    state.pause > 0u32 && state.pause <= coeffs.ipc.fade_cycles && is_refused(state)
}

/// Takes the numbers of the offered set, twice. No set is in use until they have been checked.
#[portable]
pub fn copy_offered<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, params: &Params<R>) {
    note("the offered set is copied; it is in use as soon as the copy has been checked");
    numbers::read(&mut state.now, &coeffs.ipc, params);
    numbers::take(&mut state.copy, &coeffs.ipc, &state.now);
    state.copied_set = state.offered_set;
    state.check.set_id = 0u32;
    state.set_id = 0u32;
    state.acting_set = 0u32;
    state.turn = 0u32;
    // No section runs with numbers that have not been checked.
    state.ipc.preset = false;
}

/// The numbers that were copied and checked are in use.
#[portable]
pub fn use_copied<R: Real>(state: &mut State<R>) {
    state.copied_set = 0u32;
    state.turn = 0u32;
    state.set_id = state.offered_set;
    state.acting_set = state.offered_set;
}

/// Goes on with an offered set that is not in use: checks a piece of it in each cycle; then fades out; then copies its numbers
/// and checks these. Returns the reason if it is refused.
#[portable]
pub fn look_at<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, params: &Params<R>) -> u32 {
    let mut refusal_found = error_none();
    let is_copied = state.copied_set == state.offered_set && state.set_id == 0u32;
    if state.check.set_id != state.offered_set || state.offered_set == 0u32 {
        if is_copied {
            state.turn = 0u32;
        }
        check::start(&mut state.check, coeffs, state.offered_set);
        if params.structure != coeffs.structure || state.offered_set == 0u32 {
            refusal_found = error_set_structure();
        }
    } else {
        if is_copied {
            state.check.picked.number = state.picked.number;
        } else {
            numbers::pick_offered(&mut state.check.picked, state.check.turn, &coeffs.ipc, params);
        }
        if state.check.turn < check::length(coeffs) {
            refusal_found = check::step(&mut state.check, coeffs, is_copied);
            if is_copied {
                state.turn = state.check.turn;
            }
        } else if is_copied {
            use_copied(state);
        } else {
            state.refused = error_none();
            if state.ipc.fade == 0u32 {
                copy_offered(state, coeffs, params);
            } else {
                state.acting_set = 0u32;
            }
        }
    }
    refusal_found
}

/// Handles an offered set. Returns the reason if it is refused.
#[portable]
pub fn offer<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, params: &Params<R>) -> u32 {
    let mut reason = error_none();
    let must_wait = is_paused(state, coeffs);
    let leaves = is_leaving(state, coeffs);
    if state.offered_set == state.set_id && state.set_id != 0u32 {
        state.acting_set = state.set_id;
        state.check.set_id = 0u32;
    } else {
        if must_wait {
            state.pause -= 1u32;
        } else if !leaves {
            let refusal_found = look_at(state, coeffs, params);
            if refusal_found != error_none() {
                refuse(state, coeffs, refusal_found);
            }
        }
        // A set that was refused stays so until it has passed a check.
        let stays_refused = is_refused(state);
        reason = if stays_refused { state.refused } else { error_none() };
    }
    reason
}

/// Refuses the offered set for this reason. The set in use stays, or acts again.
#[portable]
pub fn refuse<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, refusal: u32) {
    state.refused = refusal;
    state.refused_set = state.offered_set;
    state.pause = coeffs.ipc.fade_cycles;
    state.acting_set = state.set_id;
    state.copied_set = 0u32;
    state.check.set_id = 0u32;
}

/// No set is in use, and an offered set is checked without a pause.
#[portable]
pub fn drop_set<R: Real>(state: &mut State<R>) {
    state.set_id = 0u32;
    state.acting_set = 0u32;
    state.copied_set = 0u32;
    state.pause = 0u32;
    state.check.set_id = 0u32;
}

/// Compares the number in use whose turn it is with its copy. A difference is a corrupted state. If no set is in use, the number
/// is only picked, for the check of what was copied.
#[portable]
pub fn compare_one<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    let numbers = check::length(coeffs);
    if state.turn < numbers {
        note("one number in use is compared with its copy in each cycle");
        numbers::pick(&mut state.picked, state.turn, &coeffs.ipc, &state.now, &state.copy);
        if state.set_id != 0u32 {
            if in_range(state.picked.number - state.picked.copy, R::ZERO) {
                state.turn += 1u32;
            } else {
                note(
                    "a number in use was corrupted: this cycle reports it, then the block takes the offered set over again",
                );
                state.turn = 0u32;
                ipc::disturb(&mut state.ipc, &coeffs.ipc);
            }
        }
    } else if state.turn < numbers * ROUND {
        note("every number has been compared; the rest of the round is a pause");
        state.turn += 1u32;
    } else {
        state.turn = 0u32;
    }
}

/// Before the first cycle: no set is in use.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    drop_set(state);
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

/// Enforces the limit that the block was generated with, even if the numbers in use were corrupted.
#[portable]
pub fn hold_limit<R: Real>(state: &mut ipc::State<R>, coeffs: &ipc::Coeffs<R>, outputs: &mut ipc::Outputs<R>) {
    // In OFF v_add_calculated is 0, so v_add is checked, too.
    if !(in_range(outputs.v_add, coeffs.limit) && in_range(outputs.v_add_calculated, coeffs.limit)) {
        note(
            "a number in use was corrupted: the next cycle reports the fault, then the block takes the offered set over again",
        );
        ipc::disturb(state, coeffs);
        outputs.v_add = R::ZERO;
        outputs.v_add_calculated = R::ZERO;
        outputs.limited = true;
    }
}

/// Any cycle.
#[portable]
pub fn any_cycle<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    let mut mode = inputs.mode;
    let mut reason = error_none();
    state.offered_set = inputs.params.set_id;
    ipc::count_call(&mut state.ipc, &coeffs.ipc, inputs.cycle_counter);
    if state.ipc.fade > coeffs.ipc.fade_cycles {
        // The numbers in use may be corrupted, too. This cycle reports the fault; the next one checks the offered set.
        drop_set(state);
    } else if state.offered_set != state.acting_set || state.acting_set == 0u32 {
        reason = offer(state, coeffs, &inputs.params);
        if state.set_id == 0u32 && ipc::is_mode(mode) {
            // No set is in use.
            mode = ipc::mode_off();
        } else if state.acting_set == 0u32 && mode == ipc::mode_on() {
            mode = ipc::mode_dryrun();
        }
    } else {
        state.set_id = state.acting_set;
    }
    let mut ipc_inputs = ipc::Inputs::<R>::default();
    hand_over(inputs, mode, &mut ipc_inputs);
    let mut ipc_outputs = ipc::Outputs::<R>::default();
    // The watch stays tripped until the caller's own mode is not ON.
    ipc::rearm(&mut state.ipc, &coeffs.ipc, inputs.mode, inputs.reset);
    ipc::go_on(&mut state.ipc, &with_numbers(&coeffs.ipc, &state.now), &ipc_inputs, &mut ipc_outputs);
    hold_limit(&mut state.ipc, &coeffs.ipc, &mut ipc_outputs);
    put_out(state.set_id, &ipc_outputs, reason, outputs);
}

/// One cycle. It starts with the fast path: the set in use is the offered one, and only the sections change. It has the same
/// result as `any_cycle`, with fewer conditions.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    compare_one(state, coeffs);
    let mut ipc_inputs = ipc::Inputs::<R>::default();
    hand_over(inputs, inputs.mode, &mut ipc_inputs);
    if inputs.params.set_id == state.acting_set
        && ipc::may_act_in_full(&coeffs.ipc, &ipc_inputs)
        && call_rate::is_usual(&state.ipc.call_rate, &coeffs.ipc.call_rate, inputs.cycle_counter)
        && state.ipc.fade == coeffs.ipc.fade_cycles
        && !(coeffs.ipc.watch.active && state.ipc.watch.tripped)
        && (!coeffs.ipc.ride_through.active || state.ipc.ride_through.bad == 0u32)
    {
        note("the fast path: the offered set is in use, the mode is ON, and the fade is full");
        let mut ipc_outputs = ipc::Outputs::<R>::default();
        call_rate::go_on(&mut state.ipc.call_rate, &coeffs.ipc.call_rate, inputs.cycle_counter);
        ipc::act_in_full(&mut state.ipc, &with_numbers(&coeffs.ipc, &state.now), &ipc_inputs, &mut ipc_outputs);
        ipc::tell_trip(&state.ipc, &coeffs.ipc, &mut ipc_outputs);
        hold_limit(&mut state.ipc, &coeffs.ipc, &mut ipc_outputs);
        put_out(state.acting_set, &ipc_outputs, error_none(), outputs);
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
    const ENABLE: Option<Enable> =
        Some(Enable { input: "mode", off: Off::Mode(&ipc::mode_off::Ir::<R>::IR, "ipc.preset") });
    const SET: Option<&'static str> = Some("params");

    fn is_usual_first(_: &Coeffs<R>) -> bool {
        true
    }

    fn inputs(coeffs: &Coeffs<R>) -> Inputs<R> {
        Inputs { mode: coeffs.ipc.enable, position_controlled: true, params: params(coeffs), ..Inputs::default() }
    }

    fn exercise(inputs: &mut Inputs<R>, _: &Coeffs<R>) {
        inputs.mode = ipc::mode_on();
    }
}
