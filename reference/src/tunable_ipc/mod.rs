//! Improved position control whose numbers come from parameter sets: the block `ipc` of an axis with `tunable = "all"`.
//!
//! The cycle is that of [`crate::ipc`]. The structure (stages, modes, filters, cycle time) is fixed; the numbers are those of
//! the set in use, which is kept in the state. A set with another set number is offered, and is taken over through the fade:
//!
//! ```text
//! offered         checked; if refused, the error id is reported and the set in use stays active
//! fade out        as in DRYRUN
//! fade at 0       checked again, taken over, all within one cycle; the sections start from the steady state of the present input
//! fade in         as mode says
//! ```
//!
//! The state holds the numbers in use twice and compares one of them with its copy in each cycle. A difference is a
//! corrupted state (error 3): then no set is in use until the offered one has been checked and taken over again. The limit
//! in the generated block applies to every set. A set is read once: the copy is checked, and the copy is taken over. A
//! refused set is checked again after fade_cycles cycles, when another task has finished writing it. Until the first set is
//! taken over v_add is 0, and a refused set is a fault.

#![expect(clippy::needless_range_loop, reason = "the portable subset has one way to go through an array")]

mod signals;

pub use signals::{Inputs, Outputs};

use crate::check_word::{Forming, Word, add};
use crate::ipc::numbers::{self, Numbers, Params};
use crate::ipc::{self, watch};
use crate::signal::{error_none, error_set_damaged, error_set_structure, error_set_unsound};
use crate::{call_rate, filter, stage, turn};
use portable::{Block, Enable, Fn, Off, Real, copy, from_u32, in_range, note, portable, with_numbers};

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// id of the block structure: a parameter set for another structure is refused
    pub structure: u32,
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
    /// cycles until a refused set is checked again
    pub pause: u32,
    /// error id of the last set that was refused
    pub refused: u32,
    /// number of the last set that was refused
    pub refused_set: u32,
    /// the numbers of the set in use
    pub now: Numbers<R>,
    /// copy of the numbers in use, or the numbers read from an offered set
    pub copy: Numbers<R>,
    /// the number to compare with its copy
    pub turn: turn::State,
    /// the cycle
    pub ipc: ipc::State<R>,
}

/// 1/2: scales each half of a 32-bit integer for the check word
#[portable]
pub fn half<R: Real>() -> R {
    R::lit(0.5)
}

/// Forms the check word of a set: of its numbers, its structure and its own number.
#[portable]
pub fn add_up<R: Real>(forming: &mut Forming<R>, coeffs: &Coeffs<R>, set_id: u32, offered: &Numbers<R>) {
    numbers::add_up(forming, &coeffs.ipc, offered);
    // Each integer is split into two halves, which are exact in every real type.
    let integers = [coeffs.structure, set_id];
    for i in 0..2 {
        let low_half = integers[i] % 65_536u32;
        let high_half = integers[i] / 65_536u32;
        let low = from_u32::<R>(low_half);
        let high = from_u32::<R>(high_half);
        let halves = [low, high];
        for k in 0..2 {
            add(forming, halves[k] * half());
        }
    }
}

/// The reason to refuse a set; no error: it is accepted. `offered`: its numbers.
#[portable]
pub fn error_of<R: Real>(coeffs: &Coeffs<R>, structure: u32, set_id: u32, check: &Word, offered: &Numbers<R>) -> u32 {
    let mut error = error_set_structure();
    if structure == coeffs.structure && set_id != 0u32 {
        error = error_set_unsound();
        let are_sound = numbers::are_sound(&coeffs.ipc, offered);
        if are_sound {
            let mut formed = Forming::<R>::default();
            add_up(&mut formed, coeffs, set_id, offered);
            let is_same = check.first == formed.word.first && check.second == formed.word.second;
            error = if in_range(formed.left_over, R::ZERO) && is_same { error_none() } else { error_set_damaged() };
        }
    }
    error
}

/// Whether the fade is on its way to 0, because of a set or of the watch.
#[portable]
pub fn is_leaving<R: Real>(coeffs: &Coeffs<R>, fade: u32, acting_set: u32, tripped: bool) -> bool {
    fade > 0u32 && (acting_set == 0u32 || coeffs.ipc.watch.active && tripped)
}

/// Whether the offered set was refused a short time ago. A corrupted state can neither extend the pause nor produce an id that
/// is not a refusal.
#[portable]
pub fn is_paused<R: Real>(state: &State<R>, coeffs: &Coeffs<R>) -> bool {
    state.pause > 0u32
        && state.pause <= coeffs.ipc.fade_cycles
        && state.offered_set == state.refused_set
        && state.refused >= error_set_structure()
        && state.refused <= error_set_damaged()
}

/// The set in use acts again: copies its numbers.
#[portable]
pub fn go_back<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    state.acting_set = state.set_id;
    numbers::take(&mut state.copy, &coeffs.ipc, &state.now);
    turn::init(&mut state.turn);
}

/// Handles an offered set. Returns the reason if it is refused.
#[portable]
pub fn offer<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, params: &Params<R>) -> u32 {
    let mut refused = error_none();
    let must_wait = is_paused(state, coeffs);
    if state.offered_set == state.set_id && state.set_id != 0u32 {
        go_back(state, coeffs);
    } else if must_wait {
        state.pause -= 1u32;
        refused = state.refused;
    } else if !is_leaving(coeffs, state.ipc.fade, state.acting_set, state.ipc.watch.tripped) {
        numbers::read(&mut state.copy, &coeffs.ipc, params);
        refused = error_of(coeffs, params.structure, state.offered_set, &params.check, &state.copy);
        if refused != error_none() {
            state.refused = refused;
            state.refused_set = state.offered_set;
            state.pause = coeffs.ipc.fade_cycles;
            go_back(state, coeffs);
        } else if state.ipc.fade == 0u32 {
            numbers::take(&mut state.now, &coeffs.ipc, &state.copy);
            turn::init(&mut state.turn);
            state.set_id = state.offered_set;
            state.acting_set = state.offered_set;
            state.ipc.preset = false;
        } else {
            state.acting_set = 0u32;
        }
    }
    refused
}

/// No set is in use, and an offered set is checked without a pause.
#[portable]
pub fn drop_set<R: Real>(state: &mut State<R>) {
    state.set_id = 0u32;
    state.acting_set = 0u32;
    state.pause = 0u32;
}

/// Compares the number whose turn it is with its copy. A difference is a corrupted state.
#[portable]
pub fn compare_one<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    let turn = state.turn.next;
    let numbers = numbers::compare(&mut state.turn, turn, &coeffs.ipc, &state.now, &state.copy);
    if turn < 0i32 {
        state.turn.next = turn::differed();
    }
    if turn >= numbers {
        note("every number has been compared; the rest of the round is a pause");
        let end = numbers * turn::ROUND;
        if turn < end {
            state.turn.next = turn + 1i32;
        } else {
            state.turn.next = 0i32;
        }
        if turn > end {
            note(
                "a number in use was corrupted: the next cycle reports the fault, then the block takes the offered set over again",
            );
            ipc::disturb(&mut state.ipc, &coeffs.ipc);
        }
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
    let mut refused = error_none();
    state.offered_set = inputs.params.set_id;
    ipc::count_call(&mut state.ipc, &coeffs.ipc, inputs.cycle_counter);
    if state.ipc.fade > coeffs.ipc.fade_cycles {
        // The numbers in use may be corrupted, too. This cycle reports the fault; the next one checks the offered set.
        drop_set(state);
    } else if state.offered_set != state.acting_set || state.acting_set == 0u32 {
        refused = offer(state, coeffs, &inputs.params);
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
    if state.acting_set != 0u32 {
        compare_one(state, coeffs);
    }
    put_out(state.set_id, &ipc_outputs, refused, outputs);
}

/// One cycle. It starts with the fast path: the set in use is the offered one, and only the sections change. It has the same
/// result as `any_cycle`, with fewer conditions.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    let mut ipc_inputs = ipc::Inputs::<R>::default();
    hand_over(inputs, inputs.mode, &mut ipc_inputs);
    if inputs.params.set_id == state.acting_set
        && ipc::may_act_in_full(&coeffs.ipc, &ipc_inputs)
        && call_rate::is_usual(&state.ipc.call_rate, &coeffs.ipc.call_rate, inputs.cycle_counter)
        && state.ipc.fade == coeffs.ipc.fade_cycles
        && !(coeffs.ipc.watch.active && state.ipc.watch.tripped)
        && (!coeffs.ipc.ride_through.active || state.ipc.ride_through.bad == 0u32)
    {
        let mut ipc_outputs = ipc::Outputs::<R>::default();
        call_rate::go_on(&mut state.ipc.call_rate, &coeffs.ipc.call_rate, inputs.cycle_counter);
        ipc::act_in_full(&mut state.ipc, &with_numbers(&coeffs.ipc, &state.now), &ipc_inputs, &mut ipc_outputs);
        ipc::tell_trip(&state.ipc, &coeffs.ipc, &mut ipc_outputs);
        hold_limit(&mut state.ipc, &coeffs.ipc, &mut ipc_outputs);
        compare_one(state, coeffs);
        put_out(state.acting_set, &ipc_outputs, error_none(), outputs);
    } else {
        any_cycle(state, coeffs, inputs, outputs);
    }
}

/// The numbers of a block.
pub fn numbers_of<R: Real>(ipc: &ipc::Coeffs<R>) -> Numbers<R> {
    let of_filter = |filter: &filter::Coeffs<R>| filter::Numbers { bandpass: filter.bandpass, allpass: filter.allpass };
    let of_stage = |stage: &stage::Coeffs<R>| stage::Numbers {
        oscillation: stage.oscillation,
        filter: stage.filter.each_ref().map(of_filter),
        gain: stage.gain,
    };
    Numbers {
        limit: ipc.limit,
        lower_limit: ipc.lower_limit,
        sum_limit: ipc.sum_limit,
        watch: watch::Numbers { quiet: ipc.watch.quiet },
        stage: ipc.stage.each_ref().map(of_stage),
    }
}

/// The parameter set with the numbers of a block.
pub fn params<R: Real>(coeffs: &Coeffs<R>) -> Params<R> {
    let Coeffs { structure, set_id, ipc } = coeffs;
    let Numbers { limit, lower_limit, sum_limit, watch, stage } = numbers_of(ipc);
    let (structure, set_id) = (*structure, *set_id);
    let mut formed = Forming::<R>::default();
    add_up(&mut formed, coeffs, set_id, &numbers_of(ipc));
    Params { structure, set_id, check: formed.word, limit, lower_limit, sum_limit, watch, stage }
}

/// The reason why the block would refuse a set that does not change; no error: it accepts the set.
pub fn refusal<R: Real>(coeffs: &Coeffs<R>, params: &Params<R>) -> u32 {
    let mut offered = Numbers::<R>::default();
    numbers::read(&mut offered, &coeffs.ipc, params);
    error_of(coeffs, params.structure, params.set_id, &params.check, &offered)
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct TunableIpc;

impl<R: Real> Block<R> for TunableIpc {
    type Coeffs = Coeffs<R>;
    type State = State<R>;
    type Inputs = Inputs<R>;
    type Outputs = Outputs<R>;

    const NAME: &'static str = <ipc::Ipc as Block<R>>::NAME;
    const ENABLE: Option<Enable> =
        Some(Enable { input: "mode", off: Off::Mode(&ipc::mode_off::Ir::<R>::IR, "ipc.preset") });
    const SET: Option<&'static str> = Some("params");
    const INIT: Fn = init::Ir::<R>::IR;
    const STEP: Fn = step::Ir::<R>::IR;

    fn is_usual_first(_: &Coeffs<R>) -> bool {
        true
    }

    fn memory() -> State<R> {
        State::default()
    }

    fn init(state: &mut State<R>) {
        init(state);
    }

    fn inputs(coeffs: &Coeffs<R>) -> Inputs<R> {
        Inputs { mode: coeffs.ipc.enable, position_controlled: true, params: params(coeffs), ..Inputs::default() }
    }

    fn exercise(inputs: &mut Inputs<R>, _: &Coeffs<R>) {
        inputs.mode = ipc::mode_on();
    }

    fn outputs() -> Outputs<R> {
        Outputs::default()
    }

    fn step(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
        step(state, coeffs, inputs, outputs);
    }
}
