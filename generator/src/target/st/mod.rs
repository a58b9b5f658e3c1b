//! IEC 61131-3 Structured Text: one printer, and what its dialects do differently. The skeletons of the files are templates.
//!
//! Whatever implementations disagree on is not printed: see `docs/structured-text.md`.

mod block;
pub mod codesys;
pub mod dialect;
mod expression;
mod forms;
pub mod names;
pub mod nearest;
pub mod operands;
pub mod plain;
pub mod print;
pub mod scl;
pub mod start;
pub mod twincat;
pub mod types;

use super::Unit;
use portable::RealKind;

/// The real types that a set uses.
fn real_types(units: &[Unit<'_>]) -> impl Iterator<Item = RealKind> {
    [RealKind::F64, RealKind::F32].into_iter().filter(|real| units.iter().any(|unit| unit.real == *real))
}
