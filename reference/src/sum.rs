//! The start value of a sum whose terms are selected per axis. No terms here.

use portable::{Real, portable};

/// start of a sum, -0: `-0 + x` is x for every x
///
/// With +0 the first term would need a special case, because +0 + -0 is +0. A block with a first term does not contain this
/// addition: the specialiser knows the identity (docs/decisions/source.md).
#[portable]
pub fn empty_sum<R: Real>() -> R {
    R::lit(-0.0)
}
