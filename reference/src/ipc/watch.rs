//! The watch over the loop: whether the sum of the stages swings as that of an unstable loop does. It decides; the fade is moved elsewhere.
//!
//! ```text
//! span = highest - lowest v_sum of a block of block_cycles cycles
//! both limits reached, and span > 0.9 span of the block before:            score + 2
//! else span > 1.1 span of the block before, which was not quiet:           score + 1
//! else both limits reached:                                                score - 1, at least 0
//! else:                                                                    score = 0
//! score >= alarm and span > 2 limit:                                       tripped
//! ```
//!
//! What a move, a blow or a burst of chatter leaves behind dies away: a block that is quieter than the one before counts back, and begins anew where it no
//! longer fills the limits.

use portable::{Real, note, portable};

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// whether the loop is watched at all
    pub active: bool,
    /// cycles of a block: 0.6 periods of the lowest f0, at least 30 ms
    pub block_cycles: u32,
    /// score that trips: 2 for a block at both limits that does not die away, 1 for one that grows
    pub alarm: u32,
    /// growth counts from a block on that spans more than this: limit / 50, so that the begin of a move is no growth
    pub quiet: R,
}

/// Its number that is no structure.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Numbers<R> {
    /// growth counts from a block on that spans more than this: limit / 50, so that the begin of a move is no growth
    pub quiet: R,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// whether the loop was found unstable; until the mode is not ON, or reset
    pub tripped: bool,
    /// cycles of this block that are over
    pub cycles: u32,
    /// blocks in a row that speak for an unstable loop
    pub score: u32,
    /// highest sum of this block
    pub high: R,
    /// lowest sum of this block
    pub low: R,
    /// highest - lowest sum of the block before
    pub before: R,
}

/// a block grows from this part of the block before on
#[portable]
pub fn growth<R: Real>() -> R {
    R::lit(1.1)
}

/// a block dies away up to this part of the block before
#[portable]
pub fn decay<R: Real>() -> R {
    R::lit(0.9)
}

/// no loop grows for so many blocks
#[portable]
pub fn largest_score() -> u32 {
    1_000_000u32
}

/// Blocks are counted anew.
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

/// One cycle in which the sum acts: takes it before it is limited to +-limit.
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
    // Beyond it only where something has overwritten it.
    if state.cycles < coeffs.block_cycles {
        state.cycles += 1u32;
    }
    if state.cycles >= coeffs.block_cycles {
        let span = state.high - state.low;
        let fills = state.high > limit && state.low < lower_limit;
        if state.score > largest_score() {
            note("the score has been overwritten: blocks are counted anew");
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
