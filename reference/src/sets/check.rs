//! The check of a parameter set, a piece of a number in a cycle: its range, the poles of its sections, its check word.

use super::Coeffs;
use crate::check_word::{self, Forming, largest_number, limit_scale};
use crate::filter;
use crate::ipc::numbers::{self, Numbers, Params};
use crate::ipc::{self, simulates, watch};
use crate::section::{are_poles_inside, is_driven_by_change, is_stable_biquad, is_stable_trapezoidal};
use crate::signal::{error_none, error_set_damaged, error_set_structure, error_set_unsound};
use crate::stage::{self, weight_limit};
use crate::turn::{
    Picked, role_a2, role_c, role_g2, role_gain, role_limit, role_lower_limit, role_quiet, role_sum_limit,
};
use portable::{Real, in_range, portable};

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// number of the set that is checked; 0: none
    pub set_id: u32,
    /// the number whose turn it is; after the last one, the check is complete
    pub turn: u32,
    /// the number that is checked
    pub picked: Picked<R>,
    /// the number before it
    pub before: R,
    /// the number two before it
    pub two_before: R,
    /// the number three before it
    pub three_before: R,
    /// the check word
    pub forming: Forming<R>,
}

/// Starts with the first number.
#[portable]
pub fn start<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, set_id: u32) {
    state.set_id = set_id;
    state.turn = 0u32;
    check_word::start(&mut state.forming, coeffs.empty_first, coeffs.empty_second);
}

/// The number of numbers in a set.
#[portable]
pub fn length<R: Real>(coeffs: &Coeffs<R>) -> u32 {
    let mut picked = Picked::<R>::default();
    let none = Numbers::<R>::default();
    numbers::pick(&mut picked, u32::MAX, &coeffs.ipc, &none, &none)
}

/// Whether the picked number is within its range, and the section that it completes is stable. The limit is at most that of the
/// block.
#[portable]
pub fn is_sound<R: Real>(state: &State<R>, coeffs: &ipc::Coeffs<R>) -> bool {
    let number = state.picked.number;
    let role = state.picked.role;
    // Nested conditions instead of `&&`: some languages evaluate both operands, and a NaN is compared by `in_range` only.
    let mut is_sound = false;
    if role == role_limit() {
        if in_range(number, coeffs.limit) {
            is_sound = number >= R::ZERO;
        }
    } else if role == role_lower_limit() {
        is_sound = in_range(number + state.before, R::ZERO);
    } else if role == role_sum_limit() {
        if in_range(number * limit_scale(), largest_number()) {
            is_sound = number >= state.two_before;
        }
    } else if coeffs.watch.active && role == role_quiet() {
        is_sound = in_range(number, coeffs.limit);
    } else if role == role_gain() {
        is_sound = in_range(number, weight_limit());
    } else if !is_driven_by_change::<R>() && role == role_a2() {
        is_sound = is_stable_biquad(state.before, number);
    } else if is_driven_by_change::<R>() && role == role_c() {
        is_sound = is_stable_trapezoidal(state.two_before, state.before, number);
    } else if is_driven_by_change::<R>() && simulates(&coeffs.stage) && role == role_g2() {
        if in_range(number, largest_number()) {
            is_sound = are_poles_inside(state.before * state.three_before, state.before * state.two_before, number);
        }
    } else {
        is_sound = in_range(number, largest_number());
    }
    is_sound
}

/// Adds the next piece of the picked number to the check word. Returns whether it was the last one of the set.
#[portable]
pub fn add<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) -> bool {
    let number = state.picked.number;
    let scaled = if state.turn < numbers::limits(&coeffs.ipc) { number * limit_scale() } else { number };
    let is_number_done = check_word::add(&mut state.forming, scaled);
    let mut is_done = false;
    if is_number_done {
        state.three_before = state.two_before;
        state.two_before = state.before;
        state.before = number;
        state.turn += 1u32;
        is_done = state.turn >= length(coeffs);
    }
    is_done
}

/// Checks a piece of the picked number. Returns the reason if the set is refused. Numbers that were copied have been checked
/// before: only their check word is formed again.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, is_copied: bool) -> u32 {
    let mut is_in_order = true;
    if !is_copied {
        is_in_order = is_sound(state, &coeffs.ipc);
    }
    let mut refused = error_none();
    if is_in_order {
        let is_done = add(state, coeffs);
        if is_done {
            let is_word = check_word::is_word(&state.forming, state.set_id);
            refused = if is_word { error_none() } else { error_set_damaged() };
        }
    } else {
        refused = error_set_unsound();
    }
    refused
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

/// Gives a set the number that belongs to its numbers: their check word.
pub fn seal<R: Real>(coeffs: &Coeffs<R>, params: &mut Params<R>) {
    let mut state = State::<R>::default();
    start(&mut state, coeffs, 0);
    while state.turn < length(coeffs) {
        numbers::pick_offered(&mut state.picked, state.turn, &coeffs.ipc, params);
        add(&mut state, coeffs);
    }
    params.set_id = check_word::set_id(&state.forming);
}

/// The parameter set with the numbers of a block.
pub fn params<R: Real>(coeffs: &Coeffs<R>) -> Params<R> {
    let Numbers { limit, lower_limit, sum_limit, watch, stage } = numbers_of(&coeffs.ipc);
    let structure = coeffs.structure;
    let mut params = Params { structure, set_id: 0, limit, lower_limit, sum_limit, watch, stage };
    seal(coeffs, &mut params);
    params
}

/// The reason why the block would refuse a set that does not change; no error: it accepts the set.
pub fn refusal<R: Real>(coeffs: &Coeffs<R>, params: &Params<R>) -> u32 {
    if params.structure != coeffs.structure || params.set_id == 0 {
        return error_set_structure();
    }
    let mut state = State::<R>::default();
    start(&mut state, coeffs, params.set_id);
    let mut refused = error_none();
    while refused == error_none() && state.turn < length(coeffs) {
        numbers::pick_offered(&mut state.picked, state.turn, &coeffs.ipc, params);
        refused = step(&mut state, coeffs, false);
    }
    refused
}
