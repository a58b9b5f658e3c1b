//! What the parameter sets of an axis are told by. What is said of the block that takes them is in `with_sets`.

use crate::axis::Axis;
use crate::design::rounding::rounded;
use compiler::leaves;
use portable::{Literal, RealKind};
use reference::ipc::Coeffs as IpcCoeffs;
use reference::tunable_ipc::{Coeffs, params};
use xxhash_rust::xxh3::xxh3_64;

/// A number that sets are told by, as names and heads of files have it and as a PLC shows it.
pub(crate) fn shown(number: u32) -> String {
    format!("{number:08x} = {number}")
}

/// What the sets of an axis are told by: their structure, and the number of the one that its parameters make.
pub(in crate::blocks) fn sets(axis: &Axis, ipc: &IpcCoeffs<f64>) -> [u32; 2] {
    [structure(axis, ipc), set(axis, ipc)]
}

/// The structure id: a hash of the axis name, the real type and all coefficients that are not reals, except the start mode.
/// Sets of the same structure fit the same block; those of another axis never do. The number after `ipc` grows whenever a
/// number of a set gets another meaning, as B did with 3.
fn structure(axis: &Axis, ipc: &IpcCoeffs<f64>) -> u32 {
    let fixed = IpcCoeffs { enable: 0, ..*ipc };
    let mut all = leaves(&fixed);
    if !ipc.call_rate.active {
        // The last one. Where it says nothing, a structure keeps the number that it had before there was one.
        all.pop();
    }
    let kept = all.into_iter().filter(|leaf| !matches!(leaf, Literal::F64(_)));
    let real = if axis.real == RealKind::F64 { "f64" } else { "f32" };
    number(kept.fold(format!("ipc 3 {} {real}", axis.name), |text, leaf| format!("{text} {:?}", leaf.at_run_time())))
}

/// What a set is told by: a number made of all its numbers, rounded to the real type.
fn set(axis: &Axis, ipc: &IpcCoeffs<f64>) -> u32 {
    let all = match axis.real {
        RealKind::F64 => leaves(&params(&Coeffs { structure: 0, set_id: 0, ipc: *ipc })),
        RealKind::F32 => {
            let ipc: IpcCoeffs<f32> = rounded(ipc, axis.real);
            leaves(&params(&Coeffs { structure: 0, set_id: 0, ipc }))
        }
    };
    number(all.into_iter().fold(String::new(), |text, leaf| match leaf {
        Literal::F64(value) => format!("{text} {:016x}", value.to_bits()),
        Literal::F32(value) => format!("{text} {:08x}", value.to_bits()),
        Literal::Bool(_) | Literal::I32(_) | Literal::U32(_) | Literal::Usize(_) | Literal::Variant(_) => {
            format!("{text} {leaf:?}")
        }
    }))
}

/// A number of 32 bits, not 0, made of a text.
#[expect(clippy::cast_possible_truncation, reason = "the low half of a digest is one, too")]
fn number(text: String) -> u32 {
    (xxh3_64(text.as_bytes()) as u32).max(1)
}
