//! The gain of a stage, the limit of the sum of stages, and the largest sum that is not a fault.
//!
//! The last one is a bound. The norm of a filter, the sum of the magnitudes of its impulse response, bounds its output for an
//! input within +-1; for filters in series the norms multiply. For f0 Ts <= 0.45 and Q >= 1 the norms are at most
//!
//! ```text
//! band-pass     4                        of any order and prototype; 3.81 measured, below f0 Ts = 0.25 1.86
//! all-pass      4.5                      4.23 measured; 1 - 2 H of a band-pass H of order 1, so at most 1 + 2 |H| = 6.3
//! oscillation   1.25 (1 + 2 / (pi D))    half waves that decay by exp(-pi D) add up to 2 / (pi D); the 1.25 is measured
//! ```
//!
//! `tests/tests/design/norms.rs` adds up the impulse responses in all of this range. Products of norms of single sections would
//! be far larger: the two sections of a pair with distant centres amplify what the other one attenuates.

use super::inputs::Inputs;
use crate::check_word::{largest_number, limit_scale};
use crate::filter::Type;
use crate::stage::{Coeffs, FILTERS, Mode};
use portable::{Real, from_u32, portable};

/// gain = -weight: negative in all modes, because the stage moves the motor against the vibration (P-AXIS-00753 to 00755).
#[portable]
pub fn gain<R: Real>(weight: R) -> R {
    -weight
}

/// Largest |v_add| = v_add_max_fact / 1000 * v_max, in the unit of v_max (P-AXIS-00757 [0.1 %], P-AXIS-00212). The product is
/// exact for every whole v_max, so that there is one rounding.
#[portable]
pub fn limit<R: Real>(v_add_max_fact: u32, v_max: R) -> R {
    from_u32::<R>(v_add_max_fact) * v_max / R::lit(1000.0)
}

/// The lower limit: not `-limit`, so that 0 stays +0.
#[portable]
pub fn lower_limit<R: Real>(limit: R) -> R {
    R::ZERO - limit
}

/// The norm of a stage of this structure with inputs in their ranges: its largest output for velocities within +-1.
#[portable]
pub fn norm<R: Real>(structure: &Coeffs<R>, inputs: &Inputs<R>) -> R {
    let mut norm = inputs.weight;
    if structure.mode != Mode::Direct {
        norm = norm * oscillation_norm(inputs.damping);
    }
    for k in 0..FILTERS {
        match structure.filter[k].kind {
            Type::NoFilter => {}
            Type::Bandpass => norm = norm * bandpass_norm(),
            Type::Allpass => norm = norm * allpass_norm(),
        }
    }
    norm
}

constants! {
    /// largest norm of a band-pass
    pub fn bandpass_norm<R: Real>() -> R { R::lit(4.0) }
    /// largest norm of an all-pass
    pub fn allpass_norm<R: Real>() -> R { R::lit(4.5) }
}

/// The largest norm of the simulated oscillation.
#[portable]
pub fn oscillation_norm<R: Real>(damping: R) -> R {
    let half_waves = R::lit(2.0) / (R::lit(core::f64::consts::PI) * damping);
    R::lit(1.25) * (R::ONE + half_waves)
}

/// The largest sum of stages that is not a fault: 2 max(limit, v_max times the norms of the stages), and at most 2^35, which is
/// the largest limit in a parameter set. `norms`: the [`norm`]s of all stages, added up.
///
/// The factor 2 is reserve for overshoot. A larger sum shows that the memory was corrupted, or that an input is far above v_max.
#[portable]
pub fn sum_limit<R: Real>(norms: R, limit: R, v_max: R) -> R {
    let mut largest = norms * v_max;
    if largest < limit {
        largest = limit;
    }
    largest = R::lit(2.0) * largest;
    let most = largest_number::<R>() / limit_scale();
    if largest > most { most } else { largest }
}
