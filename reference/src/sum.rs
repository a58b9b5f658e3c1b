//! Where a sum starts whose terms are chosen for each axis. No term stands in here.

use portable::{Real, portable};

/// start of a sum, -0: `-0 + x` is x for every x
///
/// With +0 the first term would have to be written in another way than the others: +0 + -0 is +0. A block with a first
/// term holds no such addition: the specialiser knows the identity (docs/decisions/source.md).
#[portable]
pub fn empty_sum<R: Real>() -> R {
    R::lit(-0.0)
}
