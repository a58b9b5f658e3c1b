//! The macros of a header that a program can compare, and the named values of signals. Structs and functions are in the
//! template.

use crate::target::outline::{COMMENT_WIDTH, Group, Member, Outline};
use crate::target::{BlockIdentity, TargetBlock, unit};
use compiler::print::{c::LANGUAGE, comment};
use compiler::program::values::Signal;
use compiler::program::{Origin, Type, Var, Variable};
use portable::{Literal, RealKind};
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
    let bits = if axis.real == RealKind::F64 { 64 } else { 32 };
    let one = |name: &str, value: String, doc: &str| Macro { doc: doc.to_owned(), name: name.to_owned(), value };
    let mut macros = vec![
        one("CYCLE_TIME_NS", format!("{}u", axis.cycle_time_ns), "cycle time that the block was designed for [ns]"),
        one("REAL_BITS", bits.to_string(), "size of the real type [bit]"),
    ];
    for figure in &block.block.certificate.figures {
        macros.push(one(figure.name, (LANGUAGE.literal)(figure.value), &unit::of_axis(&figure.doc, axis.is_rotary)));
    }
    macros.extend(words(
        "PARAMETERS",
        &axis.parameters_digest,
        "digest of the parameters, as in the head of this file",
    ));
    let doc = "digest of the structure: equal for blocks that differ only in the values of their coefficients";
    macros.extend(words("STRUCTURE", &axis.structure_digest, doc));
    let program = &*block.program;
    // The inputs of a block that takes sets contain a pointer, whose size depends on the processor.
    let first = if program.has_set() { "PARAMS" } else { "INPUTS" };
    let in_first: Vec<&Variable> =
        program.inputs.iter().filter(|input| program.in_set(input).is_some() == program.has_set()).collect();
    let structs =
        [(first, in_first), ("OUTPUTS", program.outputs.iter().collect()), ("STATE", program.state.iter().collect())];
    let mut doc = "sizes of the structs [byte], if a bool has one byte and each member is aligned to its own size";
    for (name, members) in structs {
        let size = size(&members, axis.real);
        macros.push(one(&format!("{name}_SIZE"), format!("{size}u"), std::mem::take(&mut doc)));
    }
    for of in &mut macros {
        of.doc = comment::wrapped(&[comment::harmless(&of.doc)], COMMENT_WIDTH, "\n * ");
    }
    macros
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

/// The size of a struct in which each member is aligned to its size.
fn size(members: &[&Variable], real: RealKind) -> usize {
    let bytes = |ty| match (ty, real) {
        (Type::Bool, _) => 1,
        (Type::I32 | Type::U32, _) | (Type::Real, RealKind::F32) => 4,
        (Type::Real, RealKind::F64) => 8,
    };
    let (mut end, mut widest) = (0_usize, 1_usize);
    for member in members {
        let own = bytes(member.ty);
        end = end.next_multiple_of(own) + own;
        widest = widest.max(own);
    }
    // C does not allow a struct without a member.
    end.max(1).next_multiple_of(widest)
}

/// The values of signals, one group for signals with common values; then other enumerations.
pub(super) fn enumerations(outline: &Outline<'_>) -> Vec<Group> {
    let program = &*outline.block.program;
    let mut groups: Vec<(Vec<Var>, BTreeSet<usize>)> = Vec::new();
    for Signal { var, constants } in outline.printer.signals() {
        match groups.iter_mut().find(|(_, known)| !known.is_disjoint(constants)) {
            Some((signals, known)) => {
                signals.push(*var);
                known.extend(constants);
            }
            None => groups.push((vec![*var], constants.clone())),
        }
    }
    let signals =
        groups.iter().map(|(signals, constants)| group(outline, &of_signals(outline, signals), signals, constants));
    let mut enumerations: Vec<Group> = signals.collect();
    let mut rest: Vec<(&'static str, BTreeSet<usize>)> = Vec::new();
    for (index, constant) in program.constants.iter().enumerate() {
        let Origin::Variant(variant) = constant.origin else { continue };
        if groups.iter().any(|(_, known)| known.contains(&index)) {
            continue;
        }
        match rest.iter_mut().find(|(doc, _)| *doc == variant.of.doc) {
            Some((_, known)) => _ = known.insert(index),
            None => rest.push((variant.of.doc, [index].into())),
        }
    }
    enumerations.extend(rest.iter().map(|(doc, constants)| group(outline, doc, &[], constants)));
    enumerations
}

/// Named values in the order of their numbers. A comment that begins with the name of the signal is shortened by it.
fn group(outline: &Outline<'_>, note: &str, signals: &[Var], constants: &BTreeSet<usize>) -> Group {
    let program = &*outline.block.program;
    let number = |index: usize| match program.constants[index].value {
        Literal::I32(value) => i64::from(value),
        Literal::U32(value) => i64::from(value),
        other => panic!("header: {other:?} is not an integer"),
    };
    let mut order: Vec<usize> = constants.iter().copied().collect();
    order.sort_by_key(|index| (number(*index), *index));
    let member = |index: usize| {
        let doc = outline.doc(program.constants[index].doc);
        let named = signals.iter().find_map(|signal| doc.strip_prefix(&format!("{}: ", program.path(*signal))));
        let value = match program.constants[index].value {
            Literal::U32(value) => value.to_string(),
            other => (LANGUAGE.literal)(other),
        };
        let doc = named.unwrap_or(&doc).to_owned();
        Member { ty: "".into(), name: outline.printer.names().constants[index].clone(), doc, value }
    };
    Group {
        note: comment::wrapped(&[note], COMMENT_WIDTH, "\n * "),
        constants: order.into_iter().map(member).collect(),
    }
}

/// The signals that have these values.
fn of_signals(outline: &Outline<'_>, signals: &[Var]) -> String {
    let names = outline.printer.names();
    let name = |signal: &Var| {
        let kind = if matches!(signal, Var::Input(_)) { "input" } else { "output" };
        format!("the {kind} {}", names[*signal])
    };
    format!("values of {}", signals.iter().map(name).collect::<Vec<_>>().join(" and of "))
}
