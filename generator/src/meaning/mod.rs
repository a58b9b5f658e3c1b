//! What a change between two sets means for the machine, in Hz, dB, degrees and seconds. No file is read here.
//!
//! Two blocks do the same where all their coefficients are the same, however their parameters are written.
//!
//! ```text
//! axis    two axes -> what differs, a line for the axis's values, one for each stage
//! control feedforward, position control, gantry -> what differs, a line for each value
//! stage   two stages -> weight, filters, gain and phase at the centres, decay
//! number  two numbers -> as many digits as tell them apart
//! ```

mod axis;
mod control;
mod number;
mod stage;

use crate::axis::Axis;
use crate::block;
use crate::design;
use compiler::leaves;
use portable::{Literal, RealKind};

/// An axis of one of two sets, or of both.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// the name of the axis
    pub axis: String,
    /// what became of it
    pub kind: Kind,
}

/// What became of an axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// only in the new set; its block in words
    Added(Vec<String>),
    /// only in the old set
    Removed,
    /// its block does something else; in words
    Changed(Vec<String>),
    /// its block does the same
    Same,
}

/// What became of each axis: those of the old set in its order, then those that were added.
#[must_use]
pub fn changes(old: &[Axis], new: &[Axis]) -> Vec<Change> {
    let named = |axes: &'_ [Axis], name: &str| axes.iter().position(|axis| axis.name == name);
    let kept = old.iter().map(|axis| {
        let kind = named(new, &axis.name).map_or(Kind::Removed, |position| between(axis, &new[position]));
        Change { axis: axis.name.clone(), kind }
    });
    let added = new.iter().filter(|axis| named(old, &axis.name).is_none());
    let added = added.map(|axis| Change {
        axis: axis.name.clone(),
        kind: Kind::Added([axis::described(axis), control::described(axis)].concat()),
    });
    kept.chain(added).collect()
}

/// Whether some block does something else, is new or is no longer there.
#[must_use]
pub fn differ(changes: &[Change]) -> bool {
    changes.iter().any(|change| change.kind != Kind::Same)
}

/// The changes in words, ASCII.
#[must_use]
pub fn lines(changes: &[Change]) -> Vec<String> {
    if !differ(changes) {
        return vec!["no difference in what the blocks do".to_owned()];
    }
    let of = |Change { axis, kind }: &Change| -> Vec<String> {
        match kind {
            Kind::Same => vec![format!("axis {axis}: the same")],
            Kind::Removed => vec![format!("axis {axis}: removed")],
            Kind::Added(lines) => lines.iter().map(|line| format!("axis {axis}: added: {line}")).collect(),
            Kind::Changed(lines) => lines.iter().map(|line| format!("axis {axis}: {line}")).collect(),
        }
    };
    changes.iter().flat_map(of).collect()
}

fn between(old: &Axis, new: &Axis) -> Kind {
    if coefficients(old) == coefficients(new) {
        return Kind::Same;
    }
    let mut lines = axis::differences(old, new);
    lines.extend(control::differences(old, new));
    if lines.is_empty() {
        lines.push("the coefficients differ by no more than their rounding".to_owned());
    }
    Kind::Changed(lines)
}

/// All numbers of an axis's blocks, in their real type.
fn coefficients(axis: &Axis) -> (Vec<&'static str>, Vec<Literal>) {
    let numbers = match axis.real {
        RealKind::F64 => leaves(&design::position_control::of_axis::<f64>(axis)),
        RealKind::F32 => leaves(&design::position_control::of_axis::<f32>(axis)),
    };
    (block::names(axis), numbers)
}
