//! The inputs of the design of a stage, and the test whether they are in their ranges.

use crate::stage::{FILTERS, weight_limit};
use portable::{Real, in_range, portable};

/// What a filter is designed from.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct FilterInputs<R> {
    /// centre frequency [Hz]: 0 < f0 <= 500, f0 Ts <= 0.45 (P-AXIS-00751)
    pub f0: R,
    /// quality factor, 1 to 10: centre frequency / bandwidth (P-AXIS-00752)
    pub q_factor: R,
}

/// What a stage is designed from. Only the filters that exist, and the damping of INDIRECT and SET_POINT, are used.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Inputs<R> {
    /// the filters, in the order of their execution
    pub filter: [FilterInputs<R>; FILTERS],
    /// damping ratio of the simulated oscillation, above 0 and below 1 (P-AXIS-00850)
    pub damping: R,
    /// weight, above 0 and up to 7 (P-AXIS-00754/00755)
    pub weight: R,
}

/// The input that is outside its range.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrong {
    /// every input is in its range
    #[default]
    Nothing,
    /// centre frequency
    Frequency,
    /// centre frequency below the lowest one of the structure
    LowFrequency,
    /// quality factor
    QualityFactor,
    /// damping ratio
    Damping,
    /// weight
    Weight,
    /// limit of v_add
    Limit,
}

/// Largest centre frequency [Hz].
const LARGEST_F0: f64 = 500.0;

/// Largest f0 Ts: above it the tangent approaches its pole.
pub const LARGEST_SHARE: f64 = 0.45;

/// f0 Ts, Ts in whole nanoseconds: in this form 450 Hz and 1 ms make exactly 0.45.
#[must_use]
pub fn share(f0: f64, cycle_time_ns: u32) -> f64 {
    f0 * f64::from(cycle_time_ns) / 1.0e9
}

/// The highest centre frequency of a cycle time [Hz]: the largest number with f0 <= 500 and f0 Ts <= 0.45.
#[must_use]
pub fn highest_f0(cycle_time_ns: u32) -> f64 {
    let is_low = |f0: f64| share(f0, cycle_time_ns) <= LARGEST_SHARE;
    let mut f0 = LARGEST_SHARE * 1.0e9 / f64::from(cycle_time_ns);
    while !is_low(f0) {
        f0 = f0.next_down();
    }
    while f0 < LARGEST_F0 && is_low(f0.next_up()) {
        f0 = f0.next_up();
    }
    if f0 > LARGEST_F0 { LARGEST_F0 } else { f0 }
}

constants! {
    /// largest quality factor
    pub fn largest_quality<R: Real>() -> R { R::lit(10.0) }
    /// smallest weight and smallest damping ratio: 2^-50, far below any that acts; single precision and the check word of a
    /// set then cover all digits of the numbers
    pub fn smallest_ratio<R: Real>() -> R { R::lit(8.881_784_197_001_252e-16) }
}

/// Which input of a filter is outside its range. The range of f0 is from `lowest` to `highest` [Hz].
#[portable]
pub fn check_filter<R: Real>(f0: R, q_factor: R, lowest: R, highest: R) -> Wrong {
    let mut wrong = Wrong::Frequency;
    if is_frequency(f0, highest) {
        wrong = Wrong::LowFrequency;
        if f0 >= lowest {
            wrong = if is_quality(q_factor) { Wrong::Nothing } else { Wrong::QualityFactor };
        }
    }
    wrong
}

/// Whether a number is a centre frequency up to the highest one. False for a NaN, which is compared only by `in_range`.
#[portable]
pub fn is_frequency<R: Real>(f0: R, highest: R) -> bool {
    let mut is_sound = false;
    if in_range(f0, highest) {
        is_sound = f0 > R::ZERO;
    }
    is_sound
}

/// Whether a number is a quality factor in its range. False for a NaN.
#[portable]
pub fn is_quality<R: Real>(q_factor: R) -> bool {
    let mut is_sound = false;
    if in_range(q_factor, largest_quality()) {
        is_sound = q_factor >= R::ONE;
    }
    is_sound
}

/// Whether a number is a damping ratio in its range. False for a NaN.
#[portable]
pub fn is_damping<R: Real>(damping: R) -> bool {
    let mut is_sound = false;
    if in_range(damping, R::ONE) {
        is_sound = damping >= smallest_ratio() && damping < R::ONE;
    }
    is_sound
}

/// Whether a number is a weight in its range. False for a NaN.
#[portable]
pub fn is_weight<R: Real>(weight: R) -> bool {
    let mut is_sound = false;
    if in_range(weight, weight_limit()) {
        is_sound = weight >= smallest_ratio();
    }
    is_sound
}
