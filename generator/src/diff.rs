//! The semantic diff: the effect of a change between two sets on the machine, in Hz, dB, degrees, seconds and margins. No file is
//! read here.
//!
//! Two axes do the same if all coefficients of their blocks are equal, however their parameters are written. A capped weight
//! is reported as well.

use crate::axis::Stage;
use crate::blocks::{self, BLOCKS, BlockKind, Designed, Effect, Effects, is_same};
use crate::number::{literal, significant};
use crate::parameters::words::Words;
use crate::set_change::judge;
use portable::Literal;

/// The changes of each axis, in words, ASCII: the axes of the old set in its order, then the added ones; and whether a block
/// does something else, is new or no longer exists.
pub fn lines(old: &[Designed], new: &[Designed]) -> (Vec<String>, bool) {
    let named = |axes: &'_ [Designed], name: &str| axes.iter().position(|of| of.axis.name == name);
    let kept = old.iter().map(|of| match named(new, &of.axis.name) {
        Some(position) => (of, differences(of, &new[position])),
        None => (of, vec!["removed".to_owned()]),
    });
    let added = new.iter().filter(|of| named(old, &of.axis.name).is_none()).map(|of| (of, added(of)));
    let changes: Vec<(&Designed, Vec<String>)> = kept.chain(added).collect();
    if changes.iter().all(|(_, lines)| lines.is_empty()) {
        return (vec!["no difference in what the blocks do".to_owned()], false);
    }
    let same = ["the same".to_owned()];
    let lines = changes.iter().flat_map(|(of, lines)| {
        let lines = if lines.is_empty() { &same[..] } else { lines };
        lines.iter().map(|line| format!("axis {}: {line}", of.axis.name))
    });
    (lines.collect(), true)
}

/// The differences between the blocks of an axis.
fn differences(old: &Designed, new: &Designed) -> Vec<String> {
    let caps = |of: &Designed| of.axis.ipc.stage.each_ref().map(|stage| stage.as_ref().map(Stage::cap));
    if coefficients(old) == coefficients(new) && caps(old) == caps(new) {
        return blocks::differences(&surroundings(old), &surroundings(new));
    }
    let mut lines = blocks::differences(&effects(old), &effects(new));
    lines.extend(BLOCKS.into_iter().flat_map(|kind| kind.differences(old, new)));
    if lines.is_empty() {
        lines = without_words(old, new);
    }
    if lines.is_empty() {
        lines.push("the coefficients differ by no more than their rounding".to_owned());
    }
    lines.extend(by_set(old, new));
    lines
}

/// The coefficients that differ by more than their rounding, between blocks that have no words for it. The blocks and their
/// real type are the same.
fn without_words(old: &Designed, new: &Designed) -> Vec<String> {
    let of_block = |kind: &'static dyn BlockKind| {
        let values = kind.coefficients(old).into_iter().zip(kind.coefficients(new));
        let named = kind.coefficient_paths().into_iter().zip(values);
        let differ = named.filter(|(_, (old, new))| !is_rounding(*old, *new));
        differ.map(move |(path, (old, new))| {
            format!("{}: coefficient {path} {} -> {}", kind.name(), literal(old), literal(new))
        })
    };
    blocks::of_axis(&new.axis).flat_map(of_block).collect()
}

/// Whether two coefficients are equal, or two reals that differ in their last digits.
fn is_rounding(old: Literal, new: Literal) -> bool {
    match (old, new) {
        (Literal::F64(old), Literal::F64(new)) => is_same(old, new),
        (Literal::F32(old), Literal::F32(new)) => [old.next_down(), old, old.next_up()].contains(&new),
        _ => old == new,
    }
}

/// Whether a parameter set transfers the change to the block on the machine, if a version takes sets.
fn by_set(old: &Designed, new: &Designed) -> Option<String> {
    let has_sets = [old, new].iter().any(|of| of.axis.ipc.takes_sets());
    let judgement = has_sets.then(|| judge(old, new))?;
    let command = format!("axgen params-of NEW --axis {} --on OLD", new.axis.name);
    let reasons = judgement.reasons();
    match (&judgement.refused, reasons.as_slice()) {
        (None, []) if old.sets == new.sets => None,
        (None, []) => Some(format!("a parameter set is enough: {command}")),
        (None, left) if old.sets != new.sets => {
            Some(format!("a parameter set brings all but this, which needs new code: {}: {command}", left.join("; ")))
        }
        (_, reasons) => Some(format!("new code is needed, a parameter set is not enough: {}", reasons.join("; "))),
    }
}

/// The values of the axis itself, and its blocks.
fn effects(of: &Designed) -> Effects {
    let values = [
        ("cycle time", Effect::Number(cycle_time(of), " us")),
        ("v_max", Effect::Number(of.axis.ipc.v_max, "")),
        ("real type", Effect::Words(of.axis.real_name().to_owned())),
        ("calls", Effect::Words(of.axis.calls().to_owned())),
        ("blocks", Effect::Words(blocks::names(&of.axis).join(", "))),
    ];
    let own = values.into_iter().map(|(what, value)| (what.to_owned(), value));
    own.chain(surroundings(of)).collect()
}

/// What no coefficient shows: the unit of the signals, and whose v_add a gantry slave gets.
fn surroundings(of: &Designed) -> Effects {
    let master = of.axis.control.master.map_or_else(|| "none".to_owned(), |number| format!("axis {number}"));
    let slaves = &of.axis.control.slaves;
    let slaves = if slaves.is_empty() { "none".to_owned() } else { slaves.join(", ") };
    let values = [
        ("axis type", of.axis.control.axis_type().name().to_owned()),
        ("gantry master", master),
        ("gantry slaves", slaves),
    ];
    values.into_iter().map(|(what, value)| (what.to_owned(), Effect::Words(value))).collect()
}

/// The lines of an axis that has no older version.
fn added(of: &Designed) -> Vec<String> {
    let (real, cycle_time) = (of.axis.real_name(), significant(cycle_time(of), 7));
    let head = format!("{real}, cycle time {cycle_time} us, blocks {}", blocks::names(&of.axis).join(", "));
    let lines = std::iter::once(head).chain(BLOCKS.into_iter().flat_map(|kind| kind.added(of)));
    lines.map(|line| format!("added: {line}")).collect()
}

/// Cycle time [us].
fn cycle_time(of: &Designed) -> f64 {
    f64::from(of.axis.cycle_time_ns) / 1e3
}

/// All numbers of an axis's blocks, in their real type.
fn coefficients(of: &Designed) -> Vec<(&'static str, Vec<Literal>)> {
    blocks::of_axis(&of.axis).map(|kind| (kind.name(), kind.coefficients(of))).collect()
}
