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
use compiler::arithmetic::wide;
use generator::axis::Axis;
use portable::Literal;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// All constructs and events of an axis and a run of its block.
#[must_use]
pub fn shown(axis: &Axis, inputs: &Samples, outputs: &Samples) -> BTreeSet<String> {
    let mut shown = axis::shown(axis);
    shown.extend(run::shown(inputs, outputs));
    shown.extend(calls::events(inputs, outputs));
    shown.extend(control::constructs(axis));
    shown.extend(control::events(inputs, outputs));
    shown.extend(sets::events(inputs, outputs));
    shown.extend(design::events(inputs, outputs));
    shown.extend(excitation::events(inputs, outputs));
    shown.extend(spindle::constructs(axis));
    shown.extend(spindle::events(inputs, outputs));
    shown
}

/// The signals of a cycle, by their names; `None` for one that the block does not have.
struct Signals<'r> {
    places: Rc<BTreeMap<&'r str, usize>>,
    values: Vec<Literal>,
}

/// The cycles of a run.
fn cycles<'r>(inputs: &'r Samples, outputs: &'r Samples) -> impl Iterator<Item = Signals<'r>> {
    let signals = inputs.shape.signals.iter().chain(&outputs.shape.signals);
    let places: Rc<BTreeMap<_, _>> = Rc::new(signals.map(|signal| signal.name.as_str()).zip(0..).collect());
    (0..inputs.len()).map(move |sample| {
        let (mut values, mut answers) = (Vec::new(), Vec::new());
        inputs.read(sample, &mut values);
        outputs.read(sample, &mut answers);
        values.append(&mut answers);
        Signals { places: Rc::clone(&places), values }
    })
}

impl Signals<'_> {
    fn value(&self, name: &str) -> Option<Literal> {
        Some(self.values[*self.places.get(name)?])
    }

    /// A real as f64, which holds it exactly.
    fn real(&self, name: &str) -> Option<f64> {
        self.value(name).and_then(wide)
    }

    fn bool(&self, name: &str) -> Option<bool> {
        Some(self.value(name)? == Literal::Bool(true))
    }

    fn number(&self, name: &str) -> Option<u32> {
        if let Literal::U32(number) = self.value(name)? { Some(number) } else { None }
    }
}
