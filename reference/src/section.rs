//! What all second-order sections share: their state and the constant that keeps it out of the subnormal range.

use portable::{Real, portable};

/// State of a second-order section in transposed direct form II.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// what the next output takes over
    pub s1: R,
    /// what `s1` takes over
    pub s2: R,
}

/// added in every update of s2, so that a section at rest never decays into subnormal numbers
///
/// On a PLC's x86 an operation on a subnormal can take a hundred times as long as on a normal number. The value is far
/// below any velocity: 1e-30 in double, 1e-18 in single precision.
#[portable]
pub fn anti_denormal<R: Real>() -> R {
    R::per_kind(1.0e-30, 1.0e-18)
}
