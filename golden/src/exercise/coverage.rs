//! The coverage of a block by an exercise: inputs that moved, outputs that changed, states and transitions of a spindle,
//! parameter sets.

use crate::samples::Samples;
use crate::shows::spindle::STATES;
use generator::axis::Changeover;
use generator::blocks::{Block, Designed};
use portable::Literal;
use std::collections::BTreeSet;
use std::fmt;

/// The transitions of a spindle that changes over (docs/spindle.md), by their ends: on the usual way, by an error and its
/// reset, by a drive that is switched off.
const TRANSITIONS: [[usize; 2]; 11] =
    [[4, 0], [4, 3], [0, 1], [1, 2], [2, 3], [3, 4], [0, 3], [1, 3], [0, 4], [1, 4], [2, 4]];

/// With the changeover in the CNC, TO_VELOCITY takes one cycle: nothing can happen within it.
const NOT_IN_THE_CNC: [[usize; 2]; 2] = [[1, 3], [1, 4]];

/// The covered part.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Coverage {
    /// each kind with its number of items, and the items that were not reached
    pub rows: Vec<(&'static str, usize, Vec<String>)>,
}

impl Coverage {
    /// Whether everything was reached.
    #[must_use]
    pub fn is_full(&self) -> bool {
        self.rows.iter().all(|(_, _, missing)| missing.is_empty())
    }

    /// The items that were not reached, one line per kind.
    pub fn missing(&self) -> impl Iterator<Item = String> {
        let missing = self.rows.iter().filter(|(_, _, missing)| !missing.is_empty());
        missing.map(|(kind, _, missing)| format!("not among the {kind}: {}", missing.join(", ")))
    }
}

impl fmt::Display for Coverage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (row, (kind, count, missing)) in self.rows.iter().enumerate() {
            let separator = if row == 0 { "" } else { ", " };
            write!(f, "{separator}{} of {count} {kind}", count - missing.len())?;
        }
        Ok(())
    }
}

/// The coverage in a run, of the signals that the axis has.
#[must_use]
pub fn coverage(designed: &Designed, block: &Block, inputs: &Samples, outputs: &Samples) -> Coverage {
    let still = |run: &Samples, places: &[usize]| -> Vec<String> {
        let moved = run.moved(run);
        places.iter().filter(|place| !moved[**place]).map(|place| run.shape.signals[*place].name.clone()).collect()
    };
    // With a limit of 0 nothing is added.
    let is_constant = |name: &str| designed.ipc.limit == 0.0 && ["v_add", "v_add_calculated"].contains(&name);
    let can_change = |place: &&usize| !is_constant(&block.program.outputs[**place].path);
    let changing: Vec<usize> = block.for_axis.outputs.iter().filter(can_change).copied().collect();
    let mut rows = vec![
        ("inputs moved", block.for_axis.inputs.len(), still(inputs, &block.for_axis.inputs)),
        ("outputs changed", changing.len(), still(outputs, &changing)),
    ];
    if let Some(spindle) =
        designed.axis.control.spindle.as_ref().filter(|_| outputs.shape.place("spindle_state").is_some())
        && spindle.v_velocity_control_on > 0
    {
        let reached = transitions(outputs);
        let states: BTreeSet<usize> = reached.iter().flatten().copied().collect();
        let missing = (0..STATES.len()).filter(|state| !states.contains(state)).map(|state| STATES[state].to_owned());
        rows.push(("states", STATES.len(), missing.collect()));
        let in_cnc = matches!(spindle.drive, Changeover::Cnc);
        let there: Vec<_> = TRANSITIONS.iter().filter(|of| !(in_cnc && NOT_IN_THE_CNC.contains(of))).collect();
        let missing = there.iter().filter(|of| !reached.contains(**of));
        let missing = missing.map(|[from, to]| format!("{} to {}", STATES[*from], STATES[*to]));
        rows.push(("transitions", there.len(), missing.collect()));
    }
    if let Some(at) = outputs.shape.place("active_set") {
        rows.push(("events of parameter sets", 3, events_of_sets(outputs, at)));
    }
    Coverage { rows }
}

/// The pairs of consecutive states.
fn transitions(outputs: &Samples) -> BTreeSet<[usize; 2]> {
    let mut reached = BTreeSet::new();
    let Some(at) = outputs.shape.place("spindle_state") else { return reached };
    let (mut values, mut before) = (Vec::new(), None);
    for sample in 0..outputs.len() {
        outputs.read(sample, &mut values);
        let Literal::I32(state) = values[at] else { continue };
        let Some(state) = usize::try_from(state).ok().filter(|state| *state < STATES.len()) else { continue };
        if let Some(before) = before.filter(|before| *before != state) {
            reached.insert([before, state]);
        }
        before = Some(state);
    }
    reached
}

/// The missing events of parameter sets: one taken over, another one after it, one refused.
fn events_of_sets(outputs: &Samples, at: usize) -> Vec<String> {
    let error_id = outputs.shape.place("error_id");
    let (mut values, mut before, mut shown) = (Vec::new(), 0, [false; 3]);
    for sample in 0..outputs.len() {
        outputs.read(sample, &mut values);
        if let Literal::U32(now) = values[at] {
            shown[0] |= now != 0;
            shown[1] |= before != 0 && now != 0 && now != before;
            before = if now == 0 { before } else { now };
        }
        shown[2] |= error_id.is_some_and(|id| matches!(values[id], Literal::U32(6..=8)));
    }
    let words = ["a set taken over", "another set taken over", "a set refused"];
    words.into_iter().zip(shown).filter(|(_, shown)| !shown).map(|(word, _)| word.to_owned()).collect()
}
