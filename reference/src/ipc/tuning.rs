//! What the caller tunes while the block acts: a factor from 0 to 1 for each stage's weight and one for the limit. Each follows
//! its input along a ramp, so that nothing jumps.
#![expect(clippy::needless_range_loop, reason = "the portable subset has one way to go through an array")]

use super::signals::{Inputs, STAGES};
use crate::stage;
use portable::{Real, in_range, note, portable, within};

/// The inputs that tune.
pub const INPUTS: &[&str] = &["tuning_weight", "tuning_limit"];

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// whether weights and limit are inputs (key tunable)
    pub active: bool,
    /// start of tuning_weight
    pub weight: [R; STAGES],
    /// start of tuning_limit
    pub limit: R,
}

/// A factor that follows an input.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Factor<R> {
    /// value of the factor in this cycle, 0 to 1
    pub now: R,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// of each stage's weight
    pub weight: [Factor<R>; STAGES],
    /// of the limit
    pub limit: Factor<R>,
}

/// a smaller factor is set to 0, so that no product with a factor is subnormal
#[portable]
pub fn least_factor<R: Real>() -> R {
    R::lit(1.0e-6)
}

/// Whether a factor, if it exists, has reached its input. The difference is NaN if the input is NaN.
#[portable]
pub fn is_followed<R: Real>(factor: &Factor<R>, is_there: bool, wanted: R) -> bool {
    !is_there || in_range(wanted - factor.now, R::ZERO)
}

/// Whether the factor of a stage exists.
#[portable]
pub fn is_there<R: Real>(coeffs: &Coeffs<R>, stage: &stage::Coeffs<R>) -> bool {
    coeffs.active && stage.mode != stage::Mode::NotActive
}

/// Whether every factor has reached its input.
#[portable]
pub fn are_followed<R: Real>(
    state: &State<R>,
    coeffs: &Coeffs<R>,
    stages: &[stage::Coeffs<R>; STAGES],
    inputs: &Inputs<R>,
) -> bool {
    is_followed(&state.limit, coeffs.active, inputs.tuning_limit)
        && is_followed(&state.weight[0], is_there(coeffs, &stages[0]), inputs.tuning_weight[0])
        && is_followed(&state.weight[1], is_there(coeffs, &stages[1]), inputs.tuning_weight[1])
        && is_followed(&state.weight[2], is_there(coeffs, &stages[2]), inputs.tuning_weight[2])
}

/// Moves a factor towards its input by at most `step`; `jumps`: at once, because v_add is 0. Returns whether the input is
/// outside 0 to 1: the factor then keeps its value.
#[portable]
#[expect(
    clippy::collapsible_if,
    reason = "Structured Text evaluates both sides of an AND, and a NaN must not be compared"
)]
pub fn follow<R: Real>(factor: &mut Factor<R>, wanted: R, step: R, jumps: bool) -> bool {
    let mut is_held = true;
    let mut is_factor = false;
    if in_range(factor.now, R::ONE) {
        is_factor = factor.now >= R::ZERO;
    }
    if !is_factor {
        note("the factor was corrupted");
        factor.now = R::ZERO;
    }
    if in_range(wanted, R::ONE) {
        if wanted >= R::ZERO {
            is_held = false;
            let target = if wanted < least_factor() { R::ZERO } else { wanted };
            let change = target - factor.now;
            if jumps || within(change, step) {
                factor.now = target;
            } else if change > R::ZERO {
                factor.now = factor.now + step;
            } else {
                factor.now = factor.now - step;
            }
        }
    }
    is_held
}

/// Moves all factors; returns whether an input is invalid.
#[portable]
pub fn step<R: Real>(
    state: &mut State<R>,
    stages: &[stage::Coeffs<R>; STAGES],
    fade_step: R,
    jumps: bool,
    inputs: &Inputs<R>,
) -> bool {
    let mut is_held = follow(&mut state.limit, inputs.tuning_limit, fade_step, jumps);
    for i in 0..STAGES {
        if stages[i].mode != stage::Mode::NotActive {
            let is_one_held = follow(&mut state.weight[i], inputs.tuning_weight[i], fade_step, jumps);
            is_held = is_held || is_one_held;
        }
    }
    is_held
}

/// Before the first cycle. The first cycle takes the inputs at once, because v_add is still 0.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    for i in 0..STAGES {
        state.weight[i].now = R::ZERO;
    }
    state.limit.now = R::ZERO;
}
