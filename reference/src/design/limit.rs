//! The gain of a stage, the limit of the sum of stages, and the largest sum that is not a fault.
//!
//! The last one is a bound. The norm of a section, the sum of the magnitudes of its impulse response, bounds its output for an
//! input within +-1; for sections in series the norms multiply. The norms of sections are at most
//!
//! ```text
//! band-pass     c (2 + max(0, -a2))        a2: product of its poles
//! all-pass      5
//! oscillation   1.25 (1 + 2 / (pi D))
//! ```
//!
//! Band-pass: with real poles p and -q of opposite signs, p >= q >= 0, h(0) = (1 + p q) / 2, |h(1)| = h(0) (p - q), and the rest
//! sums up to at most h(0) (p^2 + q^2) / (p + q): together at most 2 + p q, because p^2 (1 + p q) <= p + q. With real poles of
//! one sign the step response has one maximum of at most 1, so that the norm is at most 2. With complex poles it is at most 1.6
//! (measured; `tests/tests/design/norms.rs`).
//!
//! All-pass: 1 - 2 H, H a band-pass with c = 1 and h(0) = (1 - a2) / 2, so that its norm is 2 |h| + a2 + |a2| - 1 <= 5.
//!
//! Oscillation: half waves that decay by exp(-pi D) add up to 2 / (pi D); the 1.25 is measured (f0 Ts <= 0.45).

use crate::check_word::{largest_number, limit_scale};
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

/// Largest norm of a band-pass section, with its c and the a2 of its biquad.
#[portable]
pub fn bandpass_norm<R: Real>(c: R, a2: R) -> R {
    if a2 < R::ZERO { c * (R::lit(2.0) - a2) } else { c * R::lit(2.0) }
}

/// Largest norm of an all-pass section.
#[portable]
pub fn allpass_norm<R: Real>() -> R {
    R::lit(5.0)
}

/// Largest norm of the simulated oscillation.
#[portable]
pub fn oscillation_norm<R: Real>(damping: R) -> R {
    R::lit(1.25) * (R::ONE + R::lit(2.0) / (R::lit(core::f64::consts::PI) * damping))
}

/// The largest sum of stages that is not a fault: 2 max(limit, v_max times the norms of the stages), and at most 2^35, which is
/// the largest limit in a parameter set. `norms`: the norms of all stages, added up.
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
