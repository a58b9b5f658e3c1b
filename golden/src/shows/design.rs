//! The events of a run of the block `set_design`, in words. Another block has none.

use crate::samples::Samples;
use portable::Literal;
use std::collections::BTreeSet;

/// The events of a run.
pub fn events(outputs: &Samples) -> BTreeSet<String> {
    let mut shown = BTreeSet::new();
    let place = |name| outputs.shape.place(name);
    let Some(((designed, active), (fault, set))) =
        place("designed").zip(place("active")).zip(place("fault").zip(place("params.set_id")))
    else {
        return shown;
    };
    // `last`: the number of the last set. `refused`: an input was refused since then.
    let (mut now, mut before, mut last, mut refused) = (Vec::new(), [false; 3], 0, false);
    for sample in 0..outputs.len() {
        outputs.read(sample, &mut now);
        let Literal::U32(set) = now[set] else { continue };
        let [designed, active, fault] = [designed, active, fault].map(|at| now[at] == Literal::Bool(true));
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
