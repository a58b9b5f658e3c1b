//! The events of parameter sets in a run, in words. A run of a block without sets has none.

use crate::samples::Samples;
use portable::Literal;
use std::collections::BTreeSet;

/// The events of a run.
pub fn events(outputs: &Samples) -> BTreeSet<String> {
    let mut shown = BTreeSet::new();
    let Some(place) = outputs.shape.place("active_set") else { return shown };
    // `last`: the last set in use. Between two sets none is in use.
    let (mut answers, mut before, mut last) = (Vec::new(), 0, 0);
    for sample in 0..outputs.len() {
        outputs.read(sample, &mut answers);
        let Literal::U32(now) = answers[place] else { continue };
        let word = match (before, now) {
            (0, 1..) if last == 0 => "a first set is taken over",
            (0, 1..) if last == now => "the last set is taken over again",
            (0, 1..) => "another set is taken over",
            (1.., 0) => "no set is in use any more",
            _ => continue,
        };
        shown.insert(word.to_owned());
        before = now;
        if now != 0 {
            last = now;
        }
    }
    shown
}
