//! The numbers of a parameter set: the limits and the numbers of the stages. They are copied, and picked one by one.

use super::signals::STAGES;
use super::{Coeffs, watch};
use crate::stage;
use crate::turn::{Picked, role_coefficient, role_limit, role_lower_limit, role_quiet, role_sum_limit};
use portable::{Real, copy, portable};

/// The numbers of the set in use.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Numbers<R> {
    /// largest |v_add| [um/s or 0.001 deg/s]
    pub limit: R,
    /// -limit [um/s or 0.001 deg/s]
    pub lower_limit: R,
    /// largest magnitude of the sum of the stages; a larger sum is a fault [um/s or 0.001 deg/s]
    pub sum_limit: R,
    /// the watch over the loop
    pub watch: watch::Numbers<R>,
    /// the stages
    pub stage: [stage::Numbers<R>; STAGES],
}

/// A parameter set: every number of a structure, and the check word over them, which is the number of the set.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Params<R> {
    /// id of the block structure that the set fits: axis, stages, modes, filters, real type, cycle time, fade, ride_through,
    /// watch, cycle_counter
    pub structure: u32,
    /// number of the set, its check word, never 0; a number other than that of the set in use offers this set to the block
    pub set_id: u32,
    /// largest |v_add|; at most the limit that the block was generated with [um/s or 0.001 deg/s]
    pub limit: R,
    /// -limit [um/s or 0.001 deg/s]
    pub lower_limit: R,
    /// largest magnitude of the sum of the stages; a larger sum is a fault [um/s or 0.001 deg/s]
    pub sum_limit: R,
    /// the watch over the loop
    pub watch: watch::Numbers<R>,
    /// the stages
    pub stage: [stage::Numbers<R>; STAGES],
}

/// Reads each number of an offered set: later writes by another task have no effect.
#[portable]
pub fn read<R: Real>(numbers: &mut Numbers<R>, structure: &Coeffs<R>, offered: &Params<R>) {
    copy!(numbers = offered: limit, lower_limit, sum_limit);
    if structure.watch.active {
        numbers.watch.quiet = offered.watch.quiet;
    }
    take_stages(&mut numbers.stage, structure, &offered.stage);
}

/// Copies other numbers.
#[portable]
pub fn take<R: Real>(numbers: &mut Numbers<R>, structure: &Coeffs<R>, others: &Numbers<R>) {
    copy!(numbers = others: limit, lower_limit, sum_limit);
    if structure.watch.active {
        numbers.watch.quiet = others.watch.quiet;
    }
    take_stages(&mut numbers.stage, structure, &others.stage);
}

/// Shows the numbers as a parameter set.
#[portable]
pub fn show<R: Real>(params: &mut Params<R>, structure: &Coeffs<R>, numbers: &Numbers<R>) {
    copy!(params = numbers: limit, lower_limit, sum_limit);
    if structure.watch.active {
        params.watch.quiet = numbers.watch.quiet;
    }
    take_stages(&mut params.stage, structure, &numbers.stage);
}

/// Copies the numbers of other stages.
#[portable]
pub fn take_stages<R: Real>(
    numbers: &mut [stage::Numbers<R>; STAGES],
    structure: &Coeffs<R>,
    others: &[stage::Numbers<R>; STAGES],
) {
    for i in 0..STAGES {
        if structure.stage[i].mode != stage::Mode::NotActive {
            stage::take(&mut numbers[i], &structure.stage[i], &others[i]);
        }
    }
}

/// The number of limits, which come first. They are scaled for the check word.
#[portable]
pub fn limits<R: Real>(structure: &Coeffs<R>) -> u32 {
    if structure.watch.active { 4u32 } else { 3u32 }
}

/// Picks the number whose turn it is, its copy, and what it is. Returns the turn after the last one.
#[portable]
pub fn pick<R: Real>(
    picked: &mut Picked<R>,
    turn: u32,
    structure: &Coeffs<R>,
    numbers: &Numbers<R>,
    copy: &Numbers<R>,
) -> u32 {
    picked.role = role_coefficient();
    if turn == 0u32 {
        picked.number = numbers.limit;
        picked.copy = copy.limit;
        picked.role = role_limit();
    }
    if turn == 1u32 {
        picked.number = numbers.lower_limit;
        picked.copy = copy.lower_limit;
        picked.role = role_lower_limit();
    }
    if turn == 2u32 {
        picked.number = numbers.sum_limit;
        picked.copy = copy.sum_limit;
        picked.role = role_sum_limit();
    }
    if structure.watch.active && turn == 3u32 {
        picked.number = numbers.watch.quiet;
        picked.copy = copy.watch.quiet;
        picked.role = role_quiet();
    }
    pick_in_stages(picked, turn, structure, &numbers.stage, &copy.stage)
}

/// Picks the number of an offered set whose turn it is, and what it is. Returns the turn after the last one.
#[portable]
pub fn pick_offered<R: Real>(picked: &mut Picked<R>, turn: u32, structure: &Coeffs<R>, offered: &Params<R>) -> u32 {
    picked.role = role_coefficient();
    if turn == 0u32 {
        picked.number = offered.limit;
        picked.role = role_limit();
    }
    if turn == 1u32 {
        picked.number = offered.lower_limit;
        picked.role = role_lower_limit();
    }
    if turn == 2u32 {
        picked.number = offered.sum_limit;
        picked.role = role_sum_limit();
    }
    if structure.watch.active && turn == 3u32 {
        picked.number = offered.watch.quiet;
        picked.role = role_quiet();
    }
    pick_in_stages(picked, turn, structure, &offered.stage, &offered.stage)
}

/// Picks the number of the stages whose turn it is. Returns the turn after the last one.
#[portable]
pub fn pick_in_stages<R: Real>(
    picked: &mut Picked<R>,
    turn: u32,
    structure: &Coeffs<R>,
    numbers: &[stage::Numbers<R>; STAGES],
    copy: &[stage::Numbers<R>; STAGES],
) -> u32 {
    let mut at = limits(structure);
    for i in 0..STAGES {
        if structure.stage[i].mode != stage::Mode::NotActive {
            at = stage::pick(picked, turn, at, &structure.stage[i], &numbers[i], &copy[i]);
        }
    }
    at
}
