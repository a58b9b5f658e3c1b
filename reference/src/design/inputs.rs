//! The inputs of the design of a stage, and the test whether they are in their ranges.

use crate::filter::Type;
use crate::stage::{Coeffs, FILTERS, Mode, weight_limit};
use portable::{Real, from_u32, in_range, portable};

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

/// The first input outside its range.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Finding {
    /// which input
    pub wrong: Wrong,
    /// index of its filter; 0 for the damping and the weight
    pub filter: u32,
}

/// largest centre frequency [Hz]
#[portable]
pub fn largest_frequency<R: Real>() -> R {
    R::lit(500.0)
}

/// largest f0 * Ts: above it the tangent approaches its pole
#[portable]
pub fn largest_share<R: Real>() -> R {
    R::lit(0.45)
}

/// largest quality factor
#[portable]
pub fn largest_quality<R: Real>() -> R {
    R::lit(10.0)
}

/// smallest weight and smallest damping ratio: 2^-50, far below any that acts; single precision and the check word of a set then
/// cover all digits of the numbers
#[portable]
pub fn smallest_ratio<R: Real>() -> R {
    R::lit(8.881_784_197_001_252e-16)
}

/// a second [ns]
#[portable]
pub fn second_ns<R: Real>() -> R {
    R::lit(1.0e9)
}

/// f0 * Ts, Ts in whole nanoseconds: in this form 450 Hz and 1 ms make exactly 0.45
#[portable]
pub fn share<R: Real>(f0: R, cycle_time_ns: u32) -> R {
    f0 * from_u32::<R>(cycle_time_ns) / second_ns()
}

/// Finds the first input of a stage outside its range. `lowest`: the lowest centre frequency [Hz] that the structure of the
/// block fits, because its fade lasts a period of it.
#[portable]
pub fn check<R: Real>(finding: &mut Finding, structure: &Coeffs<R>, inputs: &Inputs<R>, cycle_time_ns: u32, lowest: R) {
    let mut wrong = Wrong::Nothing;
    let mut filter = 0u32;
    for k in 0..FILTERS {
        if structure.filter[k].kind != Type::NoFilter && wrong == Wrong::Nothing {
            wrong = check_filter(inputs.filter[k].f0, inputs.filter[k].q_factor, cycle_time_ns, lowest);
        }
        if wrong == Wrong::Nothing {
            filter += 1u32;
        }
    }
    if wrong == Wrong::Nothing {
        filter = 0u32;
        if !is_weight(inputs.weight) {
            wrong = Wrong::Weight;
        }
        if structure.mode != Mode::Direct && !is_damping(inputs.damping) {
            wrong = Wrong::Damping;
        }
    }
    finding.wrong = wrong;
    finding.filter = filter;
}

/// Which input of a filter is outside its range.
#[portable]
pub fn check_filter<R: Real>(f0: R, q_factor: R, cycle_time_ns: u32, lowest: R) -> Wrong {
    let mut wrong = Wrong::Frequency;
    if is_frequency(f0, cycle_time_ns) {
        wrong = Wrong::LowFrequency;
        if f0 >= lowest {
            wrong = if is_quality(q_factor) { Wrong::Nothing } else { Wrong::QualityFactor };
        }
    }
    wrong
}

/// Whether a number is a centre frequency in its range. False for a NaN, which is compared only by `in_range`.
#[portable]
pub fn is_frequency<R: Real>(f0: R, cycle_time_ns: u32) -> bool {
    let mut is_sound = false;
    if in_range(f0, largest_frequency()) {
        is_sound = R::ZERO < f0 && share(f0, cycle_time_ns) <= largest_share();
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
