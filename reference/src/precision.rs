//! The real type of a block. Nothing is computed here.

use portable::{Real, portable};

/// Whether it is single precision.
#[portable]
pub fn is_single<R: Real>() -> bool {
    R::per_kind(0.0, 1.0) > R::ZERO
}
