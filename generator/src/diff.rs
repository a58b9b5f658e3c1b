//! The semantic diff: what a change between two sets means for the machine, in Hz, dB, degrees and seconds. No file is read here.
//!
//! Two axes do the same where all coefficients of their blocks are the same, however their parameters are written.

use crate::blocks::designed::Designed;
use crate::blocks::{self, Kind};
use crate::number::{pair, significant};
use portable::Literal;

/// An axis of one of two sets, or of both.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// the name of the axis
    pub axis: String,
    /// what became of it
    pub kind: ChangeKind,
}

/// What became of an axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ChangeKind {
    /// only in the new set; its blocks in words
    Added(Vec<String>),
    /// only in the old set
    Removed,
    /// its blocks do something else; in words
    Changed(Vec<String>),
    /// its blocks do the same
    Same,
}

/// What became of each axis: those of the old set in its order, then those that were added.
#[must_use]
pub fn changes(old: &[Designed], new: &[Designed]) -> Vec<Change> {
    let named = |axes: &'_ [Designed], name: &str| axes.iter().position(|of| of.axis.name == name);
    let kept = old.iter().map(|of| {
        let kind = named(new, &of.axis.name).map_or(ChangeKind::Removed, |position| between(of, &new[position]));
        Change { axis: of.axis.name.clone(), kind }
    });
    let added = new.iter().filter(|of| named(old, &of.axis.name).is_none());
    let added = added.map(|of| Change { axis: of.axis.name.clone(), kind: ChangeKind::Added(description(of)) });
    kept.chain(added).collect()
}

/// Whether some block does something else, is new or is no longer there.
#[must_use]
pub fn differ(changes: &[Change]) -> bool {
    changes.iter().any(|change| change.kind != ChangeKind::Same)
}

/// The changes in words, ASCII.
#[must_use]
pub fn lines(changes: &[Change]) -> Vec<String> {
    if !differ(changes) {
        return vec!["no difference in what the blocks do".to_owned()];
    }
    let of = |Change { axis, kind }: &Change| -> Vec<String> {
        match kind {
            ChangeKind::Same => vec![format!("axis {axis}: the same")],
            ChangeKind::Removed => vec![format!("axis {axis}: removed")],
            ChangeKind::Added(lines) => lines.iter().map(|line| format!("axis {axis}: added: {line}")).collect(),
            ChangeKind::Changed(lines) => lines.iter().map(|line| format!("axis {axis}: {line}")).collect(),
        }
    };
    changes.iter().flat_map(of).collect()
}

fn between(old: &Designed, new: &Designed) -> ChangeKind {
    if coefficients(old) == coefficients(new) {
        return ChangeKind::Same;
    }
    let mut lines = of_axis(old, new);
    lines.extend(blocks::BLOCKS.into_iter().flat_map(|kind| kind.differences(old, new)));
    if lines.is_empty() {
        lines.push("the coefficients differ by no more than their rounding".to_owned());
    }
    ChangeKind::Changed(lines)
}

/// What differs in the axis itself, and which blocks it has.
fn of_axis(old: &Designed, new: &Designed) -> Vec<String> {
    let mut lines = Vec::new();
    let mut number = |what: &str, value: &dyn Fn(&Designed) -> f64, unit: &str| {
        let [old, new] = [value(old), value(new)];
        if !blocks::is_same(old, new) {
            lines.push(format!("{what} {}{unit}", pair(old, new, 7)));
        }
    };
    number("cycle time", &cycle_time, " us");
    number("v_max", &|of| of.axis.ipc.v_max, "");
    if old.axis.real != new.axis.real {
        lines.push(format!("real type {} -> {}", old.axis.real_name(), new.axis.real_name()));
    }
    let [before, after] = [old, new].map(|of| blocks::names(&of.axis).join(", "));
    if before != after {
        lines.push(format!("blocks {before} -> {after}"));
    }
    lines
}

/// An axis that has no older version.
fn description(of: &Designed) -> Vec<String> {
    let cycle_time = significant(cycle_time(of), 7);
    let mut lines = vec![format!(
        "{}, cycle time {cycle_time} us, blocks {}",
        of.axis.real_name(),
        blocks::names(&of.axis).join(", ")
    )];
    lines.extend(blocks::BLOCKS.into_iter().flat_map(|kind| kind.description(of)));
    lines
}

/// In us.
fn cycle_time(of: &Designed) -> f64 {
    f64::from(of.axis.cycle_time_ns) / 1e3
}

/// All numbers of an axis's blocks, in their real type.
fn coefficients(of: &Designed) -> Vec<(&'static str, Vec<Literal>)> {
    blocks::of_axis(&of.axis).map(|kind: &dyn Kind| (kind.name(), kind.coefficients(of))).collect()
}
