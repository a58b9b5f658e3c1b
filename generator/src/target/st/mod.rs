//! The files of Structured Text, dialect by dialect: what goes into the templates.
//!
//! Whatever implementations disagree on is not printed: see `docs/structured-text.md`.

mod block;
pub mod codesys;
pub mod plain;
pub mod scl;
pub mod twincat;

use super::Unit;
use portable::RealKind;

/// The real types that a set uses.
fn real_types(units: &[Unit<'_>]) -> impl Iterator<Item = RealKind> {
    [RealKind::F64, RealKind::F32].into_iter().filter(|real| units.iter().any(|unit| unit.real == *real))
}
