//! The named values of a block's integer signals: modes, states, error ids. How a language writes them is in its target.

use super::outline::{COMMENT_WIDTH, Group, Member, Outline};
use compiler::print::comment;
use compiler::program::Var;
use compiler::program::values::Signal;
use portable::Literal;
use std::collections::BTreeSet;

/// The values of some signals.
pub(super) struct Values {
    /// the names of these signals, outputs last
    pub(super) signals: Vec<String>,
    /// their type
    pub(super) ty: &'static str,
    /// the constants, by position
    pub(super) constants: BTreeSet<usize>,
    /// the constants with their meanings, in the order of their numbers
    pub(super) group: Group,
}

/// The values of all signals that have named values; signals with common values are listed together.
pub(super) fn of_signals(outline: &Outline<'_>) -> Vec<Values> {
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
    let values = |(signals, constants): (Vec<Var>, BTreeSet<usize>)| {
        let names: Vec<String> = signals.iter().map(|signal| outline.printer.names()[*signal].clone()).collect();
        let kinds = signals.iter().map(|signal| if matches!(signal, Var::Input(_)) { "input" } else { "output" });
        let each: Vec<String> = kinds.zip(&names).map(|(kind, name)| format!("the {kind} {name}")).collect();
        let note = format!("values of {}", each.join(" and of "));
        let ty =
            outline.ty_of(&outline.block.program.constants[*constants.first().expect("values: a signal has values")]);
        Values { signals: names, ty, group: group(outline, &note, &signals, &constants), constants }
    };
    groups.into_iter().map(values).collect()
}

/// Named values in the order of their numbers. A comment that begins with the name of the signal is shortened by it.
pub(super) fn group(outline: &Outline<'_>, note: &str, signals: &[Var], constants: &BTreeSet<usize>) -> Group {
    let program = &*outline.block.program;
    let number = |index: usize| match program.constants[index].value {
        Literal::I32(value) => i64::from(value),
        Literal::U32(value) => i64::from(value),
        other => panic!("values: {other:?} is not an integer"),
    };
    let mut order: Vec<usize> = constants.iter().copied().collect();
    order.sort_by_key(|index| (number(*index), *index));
    let member = |index: usize| {
        let doc = outline.doc(program.constants[index].doc);
        let named = signals.iter().find_map(|signal| doc.strip_prefix(&format!("{}: ", program.path(*signal))));
        let value = match program.constants[index].value {
            Literal::U32(value) => value.to_string(),
            other => (outline.language.literal)(other),
        };
        let doc = named.unwrap_or(&doc).to_owned();
        Member { ty: "".into(), name: outline.printer.names().constants[index].clone(), doc, value }
    };
    Group {
        note: comment::wrapped(&[note], COMMENT_WIDTH, outline.next_line),
        constants: order.into_iter().map(member).collect(),
    }
}
