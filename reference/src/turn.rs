//! The comparison of the numbers in use with their copies, which detects corrupted numbers. One number is compared per cycle;
//! then comparison pauses for three times as many cycles, so that the mean cost of a cycle is small.

use portable::portable;

/// Length of a round, as a multiple of the cycles that all comparisons take.
pub const ROUND: i32 = 4;

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State {
    /// cycle in the round of comparisons, from 0 on; it selects the number to compare with its copy; a value outside the round:
    /// a number differed
    pub next: i32,
}

/// a number differed from its copy
#[portable]
pub fn differed() -> i32 {
    i32::MAX
}

/// Before the first cycle, and after other numbers have been taken over.
#[portable]
pub fn init(state: &mut State) {
    state.next = 0i32;
}
