//! The numbers of a parameter set: the limits and the numbers of the stages. They are copied, checked and added to the check
//! word.
#![expect(clippy::needless_range_loop, reason = "the portable subset has one way to go through an array")]

use super::signals::STAGES;
use super::{Coeffs, watch};
use crate::check_word::{Forming, Word, add, largest_number, limit_scale};
use crate::{stage, turn};
use portable::{Real, copy, in_range, portable, stored};

/// The numbers of the set in use.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Numbers<R> {
    /// largest |v_add|
    pub limit: R,
    /// -limit
    pub lower_limit: R,
    /// largest magnitude of the sum of the stages; a larger sum is a fault
    pub sum_limit: R,
    /// the watch over the loop
    pub watch: watch::Numbers<R>,
    /// the stages
    pub stage: [stage::Numbers<R>; STAGES],
}

/// A parameter set: every number of a structure, with the data to check it.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Params<R> {
    /// id of the block structure that the set fits: axis, stages, modes, filters, real type, cycle time, fade, ride_through,
    /// watch
    pub structure: u32,
    /// number of the set, not 0; a number other than that of the set in use offers this set to the block
    pub set_id: u32,
    /// check word, recomputed by the block from the numbers
    pub check: Word,
    /// largest |v_add|; at most the limit that the block was generated with
    pub limit: R,
    /// -limit
    pub lower_limit: R,
    /// largest magnitude of the sum of the stages; a larger sum is a fault
    pub sum_limit: R,
    /// the watch over the loop
    pub watch: watch::Numbers<R>,
    /// the stages
    pub stage: [stage::Numbers<R>; STAGES],
}

/// Reads each number of an offered set once: later writes by another task have no effect.
#[portable]
pub fn read<R: Real>(numbers: &mut Numbers<R>, structure: &Coeffs<R>, offered: &Params<R>) {
    copy!(numbers = offered: limit, lower_limit, sum_limit);
    if structure.watch.active {
        numbers.watch.quiet = offered.watch.quiet;
    }
    for i in 0..STAGES {
        if structure.stage[i].mode != stage::Mode::NotActive {
            stage::take(&mut numbers.stage[i], &structure.stage[i], &offered.stage[i]);
        }
    }
}

/// Copies other numbers.
#[portable]
pub fn take<R: Real>(numbers: &mut Numbers<R>, structure: &Coeffs<R>, others: &Numbers<R>) {
    copy!(numbers = others: limit, lower_limit, sum_limit);
    if structure.watch.active {
        numbers.watch.quiet = others.watch.quiet;
    }
    for i in 0..STAGES {
        if structure.stage[i].mode != stage::Mode::NotActive {
            stage::take(&mut numbers.stage[i], &structure.stage[i], &others.stage[i]);
        }
    }
}

/// Compares the number whose turn it is with its copy. Returns the turn after the last one.
#[portable]
pub fn compare<R: Real>(
    state: &mut turn::State,
    turn: i32,
    structure: &Coeffs<R>,
    now: &Numbers<R>,
    copy: &Numbers<R>,
) -> i32 {
    let mut at = 0i32;
    if turn == at {
        let limit_difference = stored(now.limit) - copy.limit;
        let after_limit = if in_range(limit_difference, R::ZERO) { at + 1i32 } else { turn::differed() };
        state.next = after_limit;
    }
    at += 1i32;
    if turn == at {
        let after_lower_limit =
            if in_range(stored(now.lower_limit) - copy.lower_limit, R::ZERO) { at + 1i32 } else { turn::differed() };
        state.next = after_lower_limit;
    }
    at += 1i32;
    if turn == at {
        let after_sum_limit =
            if in_range(stored(now.sum_limit) - copy.sum_limit, R::ZERO) { at + 1i32 } else { turn::differed() };
        state.next = after_sum_limit;
    }
    at += 1i32;
    if structure.watch.active {
        if turn == at {
            let quiet_difference = stored(now.watch.quiet) - copy.watch.quiet;
            let after_quiet = if in_range(quiet_difference, R::ZERO) { at + 1i32 } else { turn::differed() };
            state.next = after_quiet;
        }
        at += 1i32;
    }
    for i in 0..STAGES {
        if structure.stage[i].mode != stage::Mode::NotActive {
            at = stage::compare(state, turn, at, &structure.stage[i], &now.stage[i], &copy.stage[i]);
        }
    }
    at
}

/// Whether every number is finite, each section is stable, and the limit is at most the limit of `structure`.
#[portable]
pub fn are_sound<R: Real>(structure: &Coeffs<R>, offered: &Numbers<R>) -> bool {
    let mut are_sound_so_far = are_limits_sound(structure, offered);
    for i in 0..STAGES {
        if structure.stage[i].mode != stage::Mode::NotActive {
            let is_stage_sound = stage::is_sound(&structure.stage[i], &offered.stage[i]);
            are_sound_so_far = are_sound_so_far && is_stage_sound;
        }
    }
    are_sound_so_far
}

/// Whether 0 <= limit <= the limit of `structure`, lower_limit = -limit and sum_limit >= limit.
#[portable]
pub fn are_limits_sound<R: Real>(structure: &Coeffs<R>, offered: &Numbers<R>) -> bool {
    let mut are_sound_so_far = false;
    if in_range(offered.limit, structure.limit)
        && in_range(offered.lower_limit, structure.limit)
        && in_range(offered.sum_limit * limit_scale(), largest_number())
    {
        are_sound_so_far = offered.limit >= R::ZERO
            && in_range(offered.lower_limit + offered.limit, R::ZERO)
            && offered.sum_limit >= offered.limit;
    }
    if structure.watch.active {
        are_sound_so_far = are_sound_so_far && in_range(offered.watch.quiet, structure.limit);
    }
    are_sound_so_far
}

/// Adds all numbers to the check word.
#[portable]
pub fn add_up<R: Real>(forming: &mut Forming<R>, structure: &Coeffs<R>, offered: &Numbers<R>) {
    let limits = [offered.limit, offered.lower_limit, offered.sum_limit, offered.watch.quiet];
    for i in 0..4 {
        if i < 3usize || structure.watch.active {
            add(forming, limits[i] * limit_scale());
        }
    }
    for i in 0..STAGES {
        if structure.stage[i].mode != stage::Mode::NotActive {
            stage::add_up(forming, &structure.stage[i], &offered.stage[i]);
        }
    }
}
