//! The ids of an axis's parameter sets: structure id and set number. The texts of the block that takes them are in
//! `with_sets`.

use crate::axis::Axis;
use crate::blocks::Designed;
use crate::design::rounding::rounded;
use compiler::leaves;
use portable::{Literal, RealKind};
use reference::check_word::empty;
use reference::ipc::Coeffs as IpcCoeffs;
use reference::sets::{Coeffs, params};
use xxhash_rust::xxh3::xxh3_64;

/// An id of a set, as printed in names and heads of files and as shown by a PLC.
pub(crate) fn shown(number: u32) -> String {
    format!("{number:08x} = {number}")
}

/// The ids of an axis's sets: the structure id, and the set number of its own parameters.
pub(in crate::blocks) fn sets(axis: &Axis, ipc: &IpcCoeffs<f64>) -> [u32; 2] {
    let structure = structure(axis, ipc);
    [structure, set(structure, axis, ipc)]
}

/// The structure id: a hash of the axis name, the real type and all coefficients that are not reals, except the start mode.
/// Sets of the same structure fit the same block; those of another axis never do. The number after `ipc` is increased when
/// the meaning of a number of a set changes, as that of `set_id` did with 4.
fn structure(axis: &Axis, ipc: &IpcCoeffs<f64>) -> u32 {
    let fixed = IpcCoeffs { enable: 0, ..*ipc };
    let mut all = leaves(&fixed);
    if !ipc.call_rate.active {
        // The last coefficient belongs to the call rate. If calls are not counted, the structure id stays as it was before
        // the call rate was introduced.
        all.pop();
    }
    let kept = all.into_iter().filter(|leaf| !matches!(leaf, Literal::F64(_)));
    let real = if axis.real == RealKind::F64 { "f64" } else { "f32" };
    number(kept.fold(format!("ipc 4 {} {real}", axis.name), |text, leaf| format!("{text} {:?}", leaf.at_run_time())))
}

/// The set number: the check word of the numbers of the set, rounded to the real type.
fn set(structure: u32, axis: &Axis, ipc: &IpcCoeffs<f64>) -> u32 {
    let coeffs = with(structure, 0, ipc);
    match axis.real {
        RealKind::F64 => params(&coeffs).set_id,
        RealKind::F32 => params(&rounded::<_, Coeffs<f32>>(&coeffs, axis.real)).set_id,
    }
}

/// The coefficients of the sets of an axis.
pub(in crate::blocks) fn coefficients(designed: &Designed) -> Coeffs<f64> {
    let [structure, set_id] = designed.sets;
    with(structure, set_id, &designed.ipc)
}

/// The coefficients of sets with these ids.
pub(in crate::blocks) fn with(structure: u32, set_id: u32, ipc: &IpcCoeffs<f64>) -> Coeffs<f64> {
    let [empty_first, empty_second] = empty(structure);
    Coeffs { structure, empty_first, empty_second, set_id, ipc: *ipc }
}

/// A 32-bit hash of a text, never 0.
#[expect(clippy::cast_possible_truncation, reason = "the low half of a digest is one, too")]
fn number(text: String) -> u32 {
    (xxh3_64(text.as_bytes()) as u32).max(1)
}
