//! Searches in an interval of one variable.

/// Steps of the search for a minimum: the interval shrinks to 0.618^16, below 1/2000.
const STEPS: u32 = 16;
/// Steps of the search for a root.
const ROOT_STEPS: u32 = 60;
/// The search for a root ends when the interval is this part of its position.
const PRECISION: f64 = 1e-12;
/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The position and the value of a function's minimum in an interval with exactly one: golden section.
pub(crate) fn least(mut from: f64, mut to: f64, of: impl Fn(f64) -> f64) -> (f64, f64) {
    let mut low = to - GOLDEN * (to - from);
    let mut high = from + GOLDEN * (to - from);
    let (mut at_low, mut at_high) = (of(low), of(high));
    for _ in 0..STEPS {
        if at_low <= at_high {
            (to, high, at_high) = (high, low, at_low);
            low = to - GOLDEN * (to - from);
            at_low = of(low);
        } else {
            (from, low, at_low) = (low, high, at_high);
            high = from + GOLDEN * (to - from);
            at_high = of(high);
        }
    }
    if at_low <= at_high { (low, at_low) } else { (high, at_high) }
}

/// The position where a function is 0 between two places with different signs: the Illinois form of regula falsi.
pub(crate) fn root([mut from, mut to]: [f64; 2], [mut at_from, mut at_to]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    let mut kept = 0;
    for _ in 0..ROOT_STEPS {
        if to - from <= PRECISION * to {
            break;
        }
        let middle = from + (to - from) * (at_from / (at_from - at_to));
        let value = of(middle);
        if value == 0.0 {
            return middle;
        }
        // A side that stays twice would slow the search down: its value is halved.
        if (value < 0.0) == (at_to < 0.0) {
            (to, at_to) = (middle, value);
            at_from = if kept == 1 { at_from / 2.0 } else { at_from };
            kept = 1;
        } else {
            (from, at_from) = (middle, value);
            at_to = if kept == -1 { at_to / 2.0 } else { at_to };
            kept = -1;
        }
    }
    if libm::fabs(at_from) <= libm::fabs(at_to) { from } else { to }
}
