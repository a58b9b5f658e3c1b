//! The call rate: checks against the controller's cycle counter that the block is called once per cycle. Each block decides how
//! it reacts.
//!
//! ```text
//! counter as expected, 0, or nothing to compare it with:    score - 1, at least 0
//! the same counter again, or one or two calls missing:      score + 8
//! three calls missing or more, or any other counter:        score + 8, and the block restarts
//! score + 8 from 16 on:                                     32
//! score >= 16:                                              fault
//! ```
//!
//! One irregular call in nine is tolerated permanently. With more the score rises. A fault ends with the 17th consecutive
//! regular call. A counter of 0 means unchecked: a counter that wraps to 0 is not compared in that cycle, nor in the next one.

use portable::{note, portable};

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs {
    /// whether calls are counted (key cycle_counter)
    pub active: bool,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State {
    /// expected cycle counter of the next call; 0: any
    pub expected: u32,
    /// score of irregular calls: each irregular call raises it, each regular call lowers it by 1
    pub score: u32,
}

constants! {
    /// increase of the score for an irregular call
    pub fn irregular() -> u32 { 8u32 }
    /// the call rate is a fault from this score on
    pub fn alarm() -> u32 { 16u32 }
    /// score after the call rate has become a fault
    pub fn full() -> u32 { 32u32 }
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

/// Whether this is the expected call and the score is 0; always true if calls are not counted.
#[portable]
pub fn is_usual(state: &State, coeffs: &Coeffs, counter: u32) -> bool {
    !coeffs.active || counter == state.expected && state.score == 0u32
}

/// A regular call: expects the next one.
#[portable]
pub fn go_on(state: &mut State, coeffs: &Coeffs, counter: u32) {
    if coeffs.active {
        expect(state, counter);
    }
}

/// Expects the call after this one.
#[portable]
pub fn expect(state: &mut State, counter: u32) {
    state.expected = if counter == 0u32 { 0u32 } else { following(counter) };
}

/// One call. Returns whether the block has not been called for so long that it must restart.
#[portable]
pub fn step(state: &mut State, counter: u32) -> bool {
    let wanted = state.expected;
    expect(state, counter);
    let mut has_paused = false;
    if state.score > full() {
        note("the score was corrupted");
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

/// Whether the block is called too often or too rarely.
#[portable]
pub fn is_wrong(state: &State, coeffs: &Coeffs) -> bool {
    coeffs.active && state.score >= alarm()
}
