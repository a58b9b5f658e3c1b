//! The parameter sets of the blocks that take them (`tunable = "all"` or `"parameters"`): which set is in use, and how an offered one
//! is checked and taken over.
//!
//! The structure (stages, modes, filters, cycle time) is fixed; the numbers are those of the set in use, which is kept in the
//! state. A set with another set number is offered, and is taken over through the fade of improved position control:
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

pub use check::{numbers_of, params, refusal, seal};

use crate::ipc;
use crate::ipc::numbers::{self, Numbers, Params};
use crate::signal::{error_none, error_set_damaged, error_set_structure};
use crate::turn::Picked;
use portable::{Real, in_range, note, portable};

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

/// State, without that of improved position control.
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
}

/// Length of a round of comparisons, as a multiple of the cycles that all comparisons take. In the others nothing is compared,
/// so that the mean cost of a cycle is small.
pub const ROUND: u32 = 4;

/// Whether the fade is on its way to 0, because of a set or of the watch.
#[portable]
pub fn is_leaving<R: Real>(state: &State<R>, ipc_state: &ipc::State<R>, coeffs: &Coeffs<R>) -> bool {
    ipc_state.fade > 0u32 && (state.acting_set == 0u32 || coeffs.ipc.watch.active && ipc_state.watch.tripped)
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
pub fn copy_offered<R: Real>(
    state: &mut State<R>,
    ipc_state: &mut ipc::State<R>,
    coeffs: &Coeffs<R>,
    params: &Params<R>,
) {
    note("the offered set is copied; it is in use as soon as the copy has been checked");
    numbers::read(&mut state.now, &coeffs.ipc, params);
    numbers::take(&mut state.copy, &coeffs.ipc, &state.now);
    state.copied_set = state.offered_set;
    state.check.set_id = 0u32;
    state.set_id = 0u32;
    state.acting_set = 0u32;
    state.turn = 0u32;
    // No section runs with numbers that have not been checked.
    ipc_state.preset = false;
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
pub fn look_at<R: Real>(
    state: &mut State<R>,
    ipc_state: &mut ipc::State<R>,
    coeffs: &Coeffs<R>,
    params: &Params<R>,
) -> u32 {
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
            if ipc_state.fade == 0u32 {
                copy_offered(state, ipc_state, coeffs, params);
            } else {
                state.acting_set = 0u32;
            }
        }
    }
    refusal_found
}

/// Handles an offered set. Returns the reason if it is refused.
#[portable]
pub fn offer<R: Real>(
    state: &mut State<R>,
    ipc_state: &mut ipc::State<R>,
    coeffs: &Coeffs<R>,
    params: &Params<R>,
) -> u32 {
    let mut reason = error_none();
    let must_wait = is_paused(state, coeffs);
    let leaves = is_leaving(state, ipc_state, coeffs);
    if state.offered_set == state.set_id && state.set_id != 0u32 {
        state.acting_set = state.set_id;
        state.check.set_id = 0u32;
    } else {
        if must_wait {
            state.pause -= 1u32;
        } else if !leaves {
            let refusal_found = look_at(state, ipc_state, coeffs, params);
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
pub fn compare_one<R: Real>(state: &mut State<R>, ipc_state: &mut ipc::State<R>, coeffs: &Coeffs<R>) {
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
                ipc::disturb(ipc_state, &coeffs.ipc);
            }
        }
    } else if state.turn < numbers * ROUND {
        note("every number has been compared; the rest of the round is a pause");
        state.turn += 1u32;
    } else {
        state.turn = 0u32;
    }
}

/// Handles the offered set before a cycle. Returns the reason if it is refused.
#[portable]
pub fn prepare<R: Real>(
    state: &mut State<R>,
    ipc_state: &mut ipc::State<R>,
    coeffs: &Coeffs<R>,
    params: &Params<R>,
) -> u32 {
    let mut reason = error_none();
    state.offered_set = params.set_id;
    if ipc_state.fade > coeffs.ipc.fade_cycles {
        // The numbers in use may be corrupted, too. This cycle reports the fault; the next one checks the offered set.
        drop_set(state);
    } else if state.offered_set != state.acting_set || state.acting_set == 0u32 {
        reason = offer(state, ipc_state, coeffs, params);
    } else {
        state.set_id = state.acting_set;
    }
    reason
}

/// The mode in which improved position control runs in this cycle: OFF while no set is in use, and at most DRYRUN while the block
/// fades out for another set.
#[portable]
pub fn acting_mode<R: Real>(state: &State<R>, mode: i32) -> i32 {
    let mut mode_now = mode;
    if state.set_id == 0u32 && ipc::is_mode(mode) {
        mode_now = ipc::mode_off();
    } else if state.acting_set == 0u32 && mode == ipc::mode_on() {
        mode_now = ipc::mode_dryrun();
    }
    mode_now
}

/// Enforces `largest`, the limit that the block was generated with, even if the numbers in use were corrupted.
#[portable]
pub fn hold_limit<R: Real>(
    ipc_state: &mut ipc::State<R>,
    coeffs: &ipc::Coeffs<R>,
    largest: R,
    outputs: &mut ipc::Outputs<R>,
) {
    // In OFF v_add_calculated is 0, so v_add is checked, too.
    if !(in_range(outputs.v_add, largest) && in_range(outputs.v_add_calculated, largest)) {
        note(
            "a number in use was corrupted: the next cycle reports the fault, then the block takes the offered set over again",
        );
        ipc::disturb(ipc_state, coeffs);
        outputs.v_add = R::ZERO;
        outputs.v_add_calculated = R::ZERO;
        outputs.limited = true;
    }
}
