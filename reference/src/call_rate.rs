//! The rate of the calls: whether the block is called once in each cycle, by the controller's own counter of cycles. It decides; what follows
//! from it is each block's own.
//!
//! ```text
//! counter as expected, 0, or nothing to compare it with:    score - 1, at least 0
//! the same counter again, or one or two calls missing:      score + 8
//! three calls missing or more, or any other counter:        score + 8, and the block starts anew
//! score + 8 from 16 on:                                     32
//! score >= 16:                                              fault
//! ```
//!
//! One irregular call in nine is tolerated for good. Of a faster sequence the score grows, and a fault ends with the 17th regular call in a row.
//! A counter of 0 is none: so a counter that wraps is not compared in the cycle in which it is 0, nor in the next one.

use portable::{note, portable};

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs {
    /// whether calls are counted at all (key cycle_counter)
    pub active: bool,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State {
    /// the counter that the next call should have; 0: any
    pub expected: u32,
    /// irregular calls of late, less the regular ones after them
    pub score: u32,
}

/// what an irregular call adds to the score
#[portable]
pub fn irregular() -> u32 {
    8u32
}

/// from this score on the call rate is a fault
#[portable]
pub fn alarm() -> u32 {
    16u32
}

/// the score of a fault that has just been found
#[portable]
pub fn full() -> u32 {
    32u32
}

/// Before the first cycle.
#[portable]
pub fn init(state: &mut State) {
    state.expected = 0u32;
    state.score = 0u32;
}

/// The counter after this one; 0 after the last one.
#[portable]
pub fn following(counter: u32) -> u32 {
    if counter < u32::MAX { counter + 1u32 } else { 0u32 }
}

/// Whether this is the next call, and no irregular one is remembered; calls that are not counted always are.
#[portable]
pub fn is_usual(state: &State, coeffs: &Coeffs, counter: u32) -> bool {
    !coeffs.active || counter == state.expected && state.score == 0u32
}

/// Such a call: the next one is waited for.
#[portable]
pub fn go_on(state: &mut State, coeffs: &Coeffs, counter: u32) {
    if coeffs.active {
        expect(state, counter);
    }
}

/// Waits for the call after this one.
#[portable]
pub fn expect(state: &mut State, counter: u32) {
    state.expected = if counter == 0u32 { 0u32 } else { following(counter) };
}

/// One call. Gives whether the block has not been called for so long that it must start anew.
#[portable]
pub fn step(state: &mut State, counter: u32) -> bool {
    let wanted = state.expected;
    expect(state, counter);
    let mut has_paused = false;
    if state.score > full() {
        note("the score has been overwritten");
        state.score = full();
    }
    if counter == wanted || counter == 0u32 || wanted == 0u32 {
        if state.score > 0u32 {
            state.score -= 1u32;
        }
    } else {
        state.score = if state.score < irregular() { state.score + irregular() } else { full() };
        let is_repeated = state.expected == wanted;
        let after_one = following(wanted);
        let after_two = following(after_one);
        has_paused = !is_repeated && counter != after_one && counter != after_two;
    }
    has_paused
}

/// Whether the block is called too often or too seldom.
#[portable]
pub fn is_wrong(state: &State, coeffs: &Coeffs) -> bool {
    coeffs.active && state.score >= alarm()
}
