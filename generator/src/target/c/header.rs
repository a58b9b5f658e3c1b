//! The macros of a header that a program can compare, and the named values of signals. Structs and functions are in the
//! template.

use crate::target::outline::{COMMENT_WIDTH, Group, Outline};
use crate::target::values::{group, of_signals};
use crate::target::{BlockIdentity, TargetBlock, bits, unit};
use compiler::print::{c::LANGUAGE, comment};
use compiler::program::{Origin, Program, Type, Variable};
use portable::RealKind;
use std::collections::BTreeSet;

/// A macro, without the beginning of the block's names.
pub(super) struct Macro {
    /// the comment above it; empty if already explained
    pub(super) doc: String,
    pub(super) name: String,
    pub(super) value: String,
}

/// The figures of a block, the digests of its parameters and of its structure, and the sizes of its structs.
pub(super) fn macros(axis: &BlockIdentity, block: &TargetBlock<'_>) -> Vec<Macro> {
    let one = |name: &str, value: String, doc: &str| Macro { doc: doc.to_owned(), name: name.to_owned(), value };
    let mut macros = vec![
        one("CYCLE_TIME_NS", format!("{}u", axis.cycle_time_ns), "cycle time that the block was designed for [ns]"),
        one("REAL_BITS", bits(axis.real).to_string(), "size of the real type [bit]"),
    ];
    for figure in &block.block.certificate.figures {
        macros.push(one(figure.name, (LANGUAGE.literal)(figure.value), &unit::of_axis(&figure.doc, axis.is_rotary)));
    }
    let doc = "digest of the parameters, as in the head of this file";
    macros.extend(words("PARAMETERS", &axis.parameters_digest, doc));
    let doc = "digest of the structure: equal for blocks that differ only in the values of their coefficients";
    macros.extend(words("STRUCTURE", &axis.structure_digest, doc));
    let mut doc = "sizes of the structs [byte], if a bool has one byte and each member is aligned to its own size";
    for (name, [size, _]) in structs(&block.program) {
        // C does not allow a struct without a member.
        macros.push(one(&format!("{name}_SIZE"), format!("{}u", size.max(1)), std::mem::take(&mut doc)));
    }
    for of in &mut macros {
        of.doc = comment::wrapped(&[&of.doc], COMMENT_WIDTH, "\n * ");
    }
    macros
}

/// The structs without a pointer, each with its size and alignment.
fn structs(program: &Program) -> [(&'static str, [usize; 2]); 3] {
    // The inputs of a block that takes sets contain a pointer, whose size depends on the processor.
    let first = if program.has_set() { "PARAMS" } else { "INPUTS" };
    let in_first = program.inputs.iter().filter(|input| program.in_set(input).is_some() == program.has_set());
    let of_made = program.outputs.iter().filter(|output| program.in_made(output).is_some());
    let made_real = if program.is_made_single { RealKind::F32 } else { program.real };
    let made = room(of_made.map(|output| one_of(output.ty, made_real)));
    let own = program.outputs.iter().filter(|output| program.in_made(output).is_none());
    let size = |of: &Variable| one_of(of.ty, program.real);
    let outputs = own.map(size).chain((made[0] > 0).then_some(made));
    [(first, room(in_first.map(size))), ("OUTPUTS", room(outputs)), ("STATE", room(program.state.iter().map(size)))]
}

/// A digest of 32 hexadecimal digits in words of 32 bits, the first digits first.
fn words(name: &str, digest: &str, doc: &str) -> Vec<Macro> {
    let word = |index: usize| Macro {
        doc: if index == 0 { doc.to_owned() } else { String::new() },
        name: format!("{name}_{index}"),
        value: format!("0x{}u", &digest[8 * index..8 * (index + 1)]),
    };
    (0..4).map(word).collect()
}

/// Size and alignment of a member.
pub(super) fn one_of(ty: Type, real: RealKind) -> [usize; 2] {
    match (ty, real) {
        (Type::Bool, _) => [1; 2],
        (Type::I32 | Type::U32, _) | (Type::Real, RealKind::F32) => [4; 2],
        (Type::Real, RealKind::F64) => [8; 2],
    }
}

/// Size and alignment of a struct of members with these sizes and alignments.
fn room(members: impl Iterator<Item = [usize; 2]>) -> [usize; 2] {
    layout(members).1
}

/// The offsets of the members of such a struct; its size and alignment.
pub(super) fn layout(members: impl Iterator<Item = [usize; 2]>) -> (Vec<usize>, [usize; 2]) {
    let (mut end, mut widest) = (0_usize, 1_usize);
    let offset = |[size, alignment]: [usize; 2]| {
        let start = end.next_multiple_of(alignment);
        end = start + size;
        widest = widest.max(alignment);
        start
    };
    let offsets = members.map(offset).collect();
    (offsets, [end.next_multiple_of(widest), widest])
}

/// The values of signals, one group for signals with common values; then other enumerations.
pub(super) fn enumerations(outline: &Outline<'_>) -> Vec<Group> {
    let of_signals = of_signals(outline);
    let is_known = |index: usize| of_signals.iter().any(|values| values.constants.contains(&index));
    let mut rest: Vec<(&'static str, BTreeSet<usize>)> = Vec::new();
    for (index, constant) in outline.block.program.constants.iter().enumerate() {
        let Origin::Variant(variant) = constant.origin else { continue };
        if is_known(index) {
            continue;
        }
        match rest.iter_mut().find(|(doc, _)| *doc == variant.of.doc) {
            Some((_, known)) => _ = known.insert(index),
            None => rest.push((variant.of.doc, [index].into())),
        }
    }
    let rest: Vec<Group> = rest.iter().map(|(doc, constants)| group(outline, doc, &[], constants)).collect();
    of_signals.into_iter().map(|values| values.group).chain(rest).collect()
}
