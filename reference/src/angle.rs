//! Angles of a modulo axis, in 0.001 deg. No state.

use portable::{Real, from_i32, in_range, nearest, note, portable, truncate, within};

const TURNS: f64 = 1.0 / 360_000.0;

constants! {
    /// a full turn [0.001 deg]
    pub fn full_turn<R: Real>() -> R { R::lit(360_000.0) }
    /// 1 / full_turn
    pub fn per_turn<R: Real>() -> R { R::lit(TURNS) }
    /// largest magnitude of a position in range: its number of turns fits in 32 bits
    pub fn position_limit<R: Real>() -> R { R::per_kind(7.0e14, 1.0e9) }
    /// largest magnitude of an angle whose turns are counted: more than half a turn above the position limit
    pub fn counted_limit<R: Real>() -> R { R::per_kind(7.1e14, 2.0e9) }
    /// largest angle below a full turn [0.001 deg]
    pub fn below_full_turn<R: Real>() -> R { R::per_kind(359_999.999_999_999_94, 359_999.97) }
    /// half a turn [0.001 deg]
    pub fn half_turn<R: Real>() -> R { R::lit(180_000.0) }
    /// up to this angle the lag is certain, whatever the previous one was: from the largest lag it would take more than 130 deg
    /// in a cycle to be here the other way round [0.001 deg]
    pub fn certain_lag<R: Real>() -> R { R::lit(60_000.0) }
}

/// Whether 0 <= angle < full_turn. False for a NaN, which is compared by `in_range` only.
#[portable]
pub fn is_within_turn<R: Real>(angle: R) -> bool {
    in_range(angle, below_full_turn()) && angle >= R::ZERO
}

/// The angle within one turn: 0 <= angle < full_turn. `angle` is at most half a turn above the position limit; any other value
/// returns 0.
#[portable]
pub fn wrapped<R: Real>(angle: R) -> R {
    let mut within_turn = R::ZERO;
    if is_within_turn(angle) {
        within_turn = angle;
    } else if in_range(angle, counted_limit()) {
        let turns = truncate(angle * per_turn());
        let rest = angle - from_i32::<R>(turns) * full_turn();
        // Truncation rounds the number of turns towards 0; near a full turn it can be off by one.
        let above = if rest < R::ZERO { rest + full_turn() } else { rest };
        within_turn = if above >= full_turn() { above - full_turn() } else { above };
    } else {
        note("reached only if the block's memory was corrupted");
    }
    within_turn
}

/// The distance the shorter way round: -half a turn <= distance <= half a turn. A value that cannot be a distance of two
/// positions returns 0.
#[portable]
pub fn shortest<R: Real>(distance: R) -> R {
    let mut shorter = R::ZERO;
    if in_range(distance, counted_limit()) {
        let whole_turns = nearest(distance * per_turn());
        shorter = distance - from_i32::<R>(whole_turns) * full_turn();
    } else {
        note("reached only if the block's memory was corrupted");
    }
    shorter
}

/// Whether the lag of two positions is certain. One of them may have passed 0.
#[portable]
pub fn is_certain<R: Real>(x_command: R, x_actual: R) -> bool {
    in_range(x_command - x_actual, certain_lag())
        || in_range(x_command - x_actual - full_turn(), certain_lag())
        || in_range(x_command - x_actual + full_turn(), certain_lag())
}

/// The lag of two positions with this difference, if it is certain.
#[portable]
pub fn certain<R: Real>(difference: R) -> R {
    if within(difference, certain_lag()) {
        difference
    } else if difference > R::ZERO {
        difference - full_turn()
    } else {
        difference + full_turn()
    }
}
