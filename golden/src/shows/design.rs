//! The events of a run of the block `set_design`, in words. Another block has none.

use super::cycles;
use crate::samples::Samples;
use std::collections::BTreeSet;

/// The events of a run.
pub fn events(inputs: &Samples, outputs: &Samples) -> BTreeSet<String> {
    // `last`: the number of the last set. `refused`: an input was refused since then.
    let (mut shown, mut before, mut last, mut refused) = (BTreeSet::new(), [false; 3], 0, false);
    for of in cycles(inputs, outputs) {
        let Some(set) = of.number("params.set_id") else { break };
        let states = ["designed", "active", "fault"].map(|name| of.bool(name));
        let [Some(designed), Some(active), Some(fault)] = states else { break };
        let words = [
            (active && !before[1], "a design starts"),
            (designed && !before[0] && last == 0, "a first set is designed"),
            (designed && !before[0] && last != 0 && set != last, "another set is designed"),
            (designed && !before[0] && last == set, "the same set is designed again"),
            (fault && !before[2], "an input is refused"),
            (designed && refused, "a set after a refusal"),
        ];
        shown.extend(words.into_iter().filter(|(is, _)| *is).map(|(_, word)| word.to_owned()));
        refused = fault || refused && !designed;
        (before, last) = ([designed, active, fault], if designed { set } else { last });
    }
    shown
}
