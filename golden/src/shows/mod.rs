//! What a golden case has in it, in the words that its `shows` may use: constructs of the axis, events of the recorded
//! samples. So that a case cannot silently cease to show what it is there for.

mod axis;
mod calls;
mod control;
mod excitation;
mod run;
mod sets;
pub(crate) mod spindle;

use crate::samples::Samples;
use generator::axis::Axis;
use std::collections::BTreeSet;

/// All that an axis and a run of its block have in them.
#[must_use]
pub fn shown(axis: &Axis, inputs: &Samples, outputs: &Samples) -> BTreeSet<String> {
    let mut shown = axis::shown(axis);
    shown.extend(run::shown(inputs, outputs));
    shown.extend(calls::events(inputs, outputs));
    shown.extend(control::constructs(axis));
    shown.extend(control::events(inputs, outputs));
    shown.extend(sets::events(outputs));
    shown.extend(excitation::events(inputs, outputs));
    shown.extend(spindle::constructs(axis));
    shown.extend(spindle::events(inputs, outputs));
    shown
}
