//! Numbers in use, each compared with its copy when its turn comes, so that a number that something else has overwritten is found. One number
//! a cycle; then nothing is compared for three times as many cycles, so that the mean cost of a cycle is small.

use portable::portable;

/// A round takes as many times the cycles that all comparisons take.
pub const ROUND: i32 = 4;

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State {
    /// cycle of the round: which number is compared with its copy, from 0 on; any other: a number differed
    pub next: i32,
}

/// a number differed from its copy
#[portable]
pub fn differed() -> i32 {
    i32::MAX
}

/// Before the first cycle, and where other numbers have been taken over.
#[portable]
pub fn init(state: &mut State) {
    state.next = 0i32;
}
