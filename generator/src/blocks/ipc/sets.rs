//! The block `ipc` of an axis whose numbers come from parameter sets: what such a set is told by, and what is said of the block beside what is said of
//! one with constants.

use super::notes::note;
use crate::axis::Axis;
use crate::blocks::{Certified, Design, Designed};
use crate::design::rounding::rounded;
use compiler::leaves;
use portable::{Literal, RealKind};
use reference::ipc::Coeffs as IpcCoeffs;
use reference::tunable_ipc::{Coeffs, TunableIpc, params};
use xxhash_rust::xxh3::xxh3_64;

impl Design for TunableIpc {
    fn design(designed: &Designed) -> Coeffs<f64> {
        let [structure, set_id] = designed.sets;
        Coeffs { structure, set_id, ipc: designed.ipc }
    }
}

/// A number that sets are told by, as names and heads of files have it and as a PLC shows it.
pub(crate) fn shown(number: u32) -> String {
    format!("{number:08x} = {number}")
}

/// Its notes, made of those of the block with constants.
pub(super) fn notes(designed: &Designed, of_constants: Vec<(String, String)>) -> Vec<(String, String)> {
    let [structure, set] = designed.sets;
    let own = [
        note("structure", format!("parameter sets for the set structure {} are taken over", shown(structure))),
        note("set_id", format!("the set that the block was generated with has the number {}", shown(set))),
    ];
    // Of a stage another set has other numbers.
    let of_ipc = of_constants.into_iter().map(|(path, text)| {
        let text = if path.starts_with("stage") { format!("as generated: {text}") } else { text };
        (format!("ipc.{path}"), text)
    });
    own.into_iter().chain(of_ipc).collect()
}

/// The line of its summary.
pub(super) fn line(designed: &Designed) -> String {
    let [structure, set] = designed.sets.map(shown);
    format!("takes parameter sets of the set structure {structure}; this one is {set}")
}

/// The certificate of the block with constants, whose program does the same with the set that the block was generated with.
pub(super) fn as_generated(mut of_constants: Certified) -> Certified {
    of_constants.lines.insert(0, "Of the parameter set that the block was generated with:".to_owned());
    for figure in of_constants.figures.iter_mut().filter(|figure| figure.name == "BOUND") {
        figure.doc.push_str(", with the set that the block was generated with");
    }
    of_constants
}

/// What the sets of an axis are told by: their structure, and the number of the one that its parameters make.
pub(in crate::blocks) fn sets(axis: &Axis, ipc: &IpcCoeffs<f64>) -> [u32; 2] {
    [structure(axis, ipc), set(axis, ipc)]
}

/// What a structure is told by: a number made of the axis's name, of the real type and of every coefficient that is no real, but for the mode at
/// start. Sets of the same structure fit the same block: those of another axis never do. The number behind `ipc` grows whenever a number of a set gets
/// another meaning, as B did with 3.
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
