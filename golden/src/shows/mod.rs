//! The constructs of an axis and the events of recorded samples, in the words that the `shows` of a golden case may use.
//! They ensure that a case cannot silently lose its purpose.

mod axis;
mod calls;
mod control;
mod design;
mod excitation;
mod run;
mod sets;
pub(crate) mod spindle;

use crate::samples::Samples;
use generator::axis::Axis;
use std::collections::BTreeSet;

/// All constructs and events of an axis and a run of its block.
#[must_use]
pub fn shown(axis: &Axis, inputs: &Samples, outputs: &Samples) -> BTreeSet<String> {
    let mut shown = axis::shown(axis);
    shown.extend(run::shown(inputs, outputs));
    shown.extend(calls::events(inputs, outputs));
    shown.extend(control::constructs(axis));
    shown.extend(control::events(inputs, outputs));
    shown.extend(sets::events(outputs));
    shown.extend(design::events(outputs));
    shown.extend(excitation::events(inputs, outputs));
    shown.extend(spindle::constructs(axis));
    shown.extend(spindle::events(inputs, outputs));
    shown
}
