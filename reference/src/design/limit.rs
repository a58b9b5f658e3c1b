//! The gain of a stage and the limit of the sum of stages.

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
