//! The supplier of parameter sets: another set of the same axis, with half the limit. What is damaged, late or absent is among the events.

use crate::case::{named_block, offered};
use crate::stimulus::{Event, Window};
use generator::blocks::{Block, Designed};

/// When the other set is offered.
const OTHER: [Window; 2] =
    [Window { at: 2_000, length: 900, every: 0 }, Window { at: 40_000, length: 15_000, every: 60_000 }];

/// The events that offer it; none, if the block takes no sets.
///
/// # Panics
/// If the axis with half the limit cannot be designed: a defect of axgen.
pub(super) fn events(designed: &Designed, block: &Block) -> Vec<Event> {
    if !block.program.inputs.iter().any(|input| block.program.in_set(input).is_some()) {
        return Vec::new();
    }
    let mut other = designed.axis.clone();
    other.ipc.v_add_max_fact = other.ipc.v_add_max_fact.div_ceil(2);
    let other =
        named_block(&Designed::from(other), block.program.block).unwrap_or_else(|text| panic!("exercise: {text}"));
    OTHER.into_iter().flat_map(|window| offered(&other, window)).collect()
}
