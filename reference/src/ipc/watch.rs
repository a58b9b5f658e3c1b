//! The watch: detects whether the sum of the stages oscillates as in an unstable loop. It only decides; the block moves the
//! fade.
//!
//! ```text
//! span = highest - lowest v_sum of a block of block_cycles cycles
//! both limits reached, and span > 0.9 span of the previous block:          score + 2
//! else span > 1.1 span of the previous block, which was not quiet:         score + 1
//! else both limits reached:                                                score - 1, at least 0
//! else:                                                                    score = 0
//! score >= alarm and span > 2 limit:                                       tripped
//! limit 0:                                                                 nothing is counted: no loop is closed
//! ```
//!
//! The vibration after a move, a shock or a burst of chatter decays: a block that is quieter than the previous one lowers the
//! score, and one that does not reach both limits resets it.

use portable::{Real, note, portable};

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// whether the watch is active (key watch)
    pub active: bool,
    /// cycles of a block: 0.6 periods of the lowest f0, at least 30 ms
    pub block_cycles: u32,
    /// score at which the watch trips: a block at both limits that does not decay adds 2, a growing block adds 1
    pub alarm: u32,
    /// smallest span from which growth counts: limit / 50, so that the start of a move does not count as growth
    /// [um/s or 0.001 deg/s]
    pub quiet: R,
}

/// The number that a parameter set may change.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Numbers<R> {
    /// smallest span from which growth counts: limit / 50, so that the start of a move does not count as growth
    /// [um/s or 0.001 deg/s]
    pub quiet: R,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// TRUE after the loop was found unstable, until the mode is not ON or reset is TRUE
    pub tripped: bool,
    /// completed cycles of the present block
    pub cycles: u32,
    /// score of the consecutive blocks that indicate an unstable loop
    pub score: u32,
    /// highest v_sum of the present block
    pub high: R,
    /// lowest v_sum of the present block
    pub low: R,
    /// span of v_sum in the previous block: highest - lowest
    pub before: R,
}

/// Smallest span from which growth counts, of a limit of v_add.
#[portable]
pub fn quiet<R: Real>(limit: R) -> R {
    limit / R::lit(50.0)
}

constants! {
    /// a block counts as growing above this multiple of the previous block's span
    pub fn growth<R: Real>() -> R { R::lit(1.1) }
    /// a block counts as decaying up to this fraction of the previous block's span
    pub fn decay<R: Real>() -> R { R::lit(0.9) }
    /// upper bound of the score: no loop grows for this number of blocks
    pub fn largest_score() -> u32 { 1_000_000u32 }
}

/// Restarts the count of blocks.
#[portable]
pub fn restart<R: Real>(state: &mut State<R>) {
    state.cycles = 0u32;
    state.score = 0u32;
    state.before = R::ZERO;
}

/// Before the first cycle.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    state.tripped = false;
    restart(state);
}

/// One cycle in which the sum acts; `v_sum` is the sum before the limit.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, v_sum: R, limit: R, lower_limit: R) {
    if state.cycles == 0u32 {
        state.high = v_sum;
        state.low = v_sum;
    } else if v_sum > state.high {
        state.high = v_sum;
    } else if v_sum < state.low {
        state.low = v_sum;
    }
    // Above block_cycles only if the memory was corrupted.
    if state.cycles < coeffs.block_cycles {
        state.cycles += 1u32;
    }
    if state.cycles >= coeffs.block_cycles {
        let span = state.high - state.low;
        let fills = state.high > limit && state.low < lower_limit;
        if state.score > largest_score() {
            note("the score was corrupted: the count of blocks restarts");
            state.score = 0u32;
        }
        if fills && span > decay::<R>() * state.before {
            state.score += 2u32;
        } else if state.before > coeffs.quiet && span > growth::<R>() * state.before {
            state.score += 1u32;
        } else if !fills {
            state.score = 0u32;
        } else if state.score > 0u32 {
            state.score -= 1u32;
        }
        if state.score >= coeffs.alarm && span > limit - lower_limit {
            state.tripped = true;
        }
        state.before = span;
        state.cycles = 0u32;
    }
}
