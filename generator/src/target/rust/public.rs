//! The public numbers of a module: its figures as constants, and the named values of its signals as enums.

use crate::target::BlockIdentity;
use crate::target::outline::{Member, Outline};
use crate::target::values::{Values, of_signals};
use crate::target::{TargetBlock, unit};
use compiler::print::comment;
use compiler::print::rust::LANGUAGE;
use compiler::program::Type;
use portable::Literal;

/// The values of a signal.
pub(super) struct Enum {
    pub(super) name: String,
    /// the type of the signal
    pub(super) ty: &'static str,
    /// the signals that have these values
    pub(super) note: String,
    pub(super) variants: Vec<Variant>,
}

/// One of the values.
pub(super) struct Variant {
    pub(super) name: String,
    pub(super) constant: Member,
}

/// The figures that C has as macros.
pub(super) fn figures(axis: &BlockIdentity, block: &TargetBlock<'_>) -> Vec<Member> {
    let one = |name: &str, ty: &'static str, value: String, doc: &str| Member {
        ty: ty.into(),
        name: name.to_owned(),
        doc: doc.to_owned(),
        value,
    };
    let cycle_time = (LANGUAGE.literal)(Literal::U32(axis.cycle_time_ns));
    let mut figures = vec![one("CYCLE_TIME_NS", "u32", cycle_time, "cycle time that the block was designed for [ns]")];
    for figure in &block.block.certificate.figures {
        let ty = Type::of_literal(figure.value).expect("rust: a figure is a number");
        let doc = unit::of_axis(&figure.doc, axis.is_rotary);
        let (ty, value) = (LANGUAGE.ty(ty, axis.real), (LANGUAGE.literal)(figure.value));
        figures.push(one(figure.name, ty, value, &comment::harmless(&doc)));
    }
    let digest = |digest: &str| format!("0x{digest}");
    let doc = "digest of the parameters, as in the head of this file";
    figures.push(one("PARAMETERS", "u128", digest(&axis.parameters_digest), doc));
    let doc = "digest of the structure: equal for blocks that differ only in the values of their coefficients";
    figures.push(one("STRUCTURE", "u128", digest(&axis.structure_digest), doc));
    figures
}

/// The named values of the block's signals.
pub(super) fn enums(outline: &Outline<'_>) -> Vec<Enum> {
    let of = |Values { signals, ty, group, .. }: Values| {
        let words: Vec<Vec<&str>> = group.constants.iter().map(|value| value.name.split('_').collect()).collect();
        let names = without_common_words(&words);
        let names: Vec<String> = names.iter().map(|words| camel_case(words)).collect();
        let variants = names.into_iter().zip(group.constants);
        let variants = variants.map(|(name, constant)| Variant { name, constant }).collect();
        let words: Vec<&str> = signals.last().expect("rust: a signal has these values").split('_').collect();
        Enum { name: camel_case(&words), ty, note: group.note, variants }
    };
    of_signals(outline).into_iter().map(of).collect()
}

/// Lists of words without the words with which all begin or end; one word stays of each.
fn without_common_words<'w>(lists: &[Vec<&'w str>]) -> Vec<Vec<&'w str>> {
    let shortest = lists.iter().map(Vec::len).min().unwrap_or(1);
    let common = |word: &dyn Fn(&[&'w str], usize) -> &'w str, most: usize| {
        (0..most).take_while(|at| lists.iter().all(|list| word(list, *at) == word(&lists[0], *at))).count()
    };
    let first = common(&|list, at| list[at], shortest - 1);
    let last = common(&|list, at| list[list.len() - 1 - at], shortest - 1 - first);
    lists.iter().map(|list| list[first..list.len() - last].to_vec()).collect()
}

/// `TO_VELOCITY` as `ToVelocity`.
fn camel_case(words: &[&str]) -> String {
    let word = |word: &&str| {
        let (first, rest) = word.split_at(1);
        first.to_ascii_uppercase() + &rest.to_ascii_lowercase()
    };
    words.iter().map(word).collect()
}
