//! The events of parameter sets in a run, in words. A run of a block without sets has none.

use super::cycles;
use crate::samples::Samples;
use std::collections::BTreeSet;

/// The events of a run.
pub fn events(inputs: &Samples, outputs: &Samples) -> BTreeSet<String> {
    // `last`: the last set in use. Between two sets none is in use.
    let (mut shown, mut before, mut last) = (BTreeSet::new(), 0, 0);
    for of in cycles(inputs, outputs) {
        let Some(now) = of.number("active_set") else { break };
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
