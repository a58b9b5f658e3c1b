//! The files of Structured Text, dialect by dialect: what goes into the templates.
//!
//! Whatever implementations disagree on is not printed: see `docs/structured-text.md`.

mod block;
pub(super) mod codesys;
pub(super) mod plain;
pub(super) mod scl;
pub(super) mod twincat;

use super::Unit;
use portable::RealKind;

/// The real types that a set uses.
fn real_types(units: &[Unit<'_>]) -> impl Iterator<Item = RealKind> {
    [RealKind::F64, RealKind::F32].into_iter().filter(|real| units.iter().any(|unit| unit.real == *real))
}
