//! The supplier of parameter sets: another set of the same axis, with half the limit, and damaged, late or absent ones.

use crate::case::{named_block, offered};
use crate::stimulus::{Event, Window};
use compiler::program::Program;
use generator::blocks::{Block, Designed};

/// The times at which the other set is offered.
const OTHER: [Window; 2] =
    [Window { at: 2_000, length: 900, every: 0 }, Window { at: 40_000, length: 15_000, every: 60_000 }];

/// The events that offer the other set; empty if the block takes no sets.
///
/// # Panics
/// If the axis with half the limit cannot be designed: a defect of axgen.
pub(super) fn other(designed: &Designed, block: &Block) -> Vec<Event> {
    if !block.program.inputs.iter().any(|input| block.program.in_set(input).is_some()) {
        return Vec::new();
    }
    let mut other = designed.axis.clone();
    other.ipc.v_add_max_fact = other.ipc.v_add_max_fact.div_ceil(2);
    let other =
        named_block(&Designed::from(other), block.program.block).unwrap_or_else(|text| panic!("exercise: {text}"));
    OTHER.into_iter().flat_map(|window| offered(&other, window)).collect()
}

/// Parameter sets other than the one with which the block was generated: memory of zeros up to the fifth cycle and again
/// later, a set without a number, another number before its contents, a NaN.
pub(super) fn damaged(block: &Program) -> Vec<Event> {
    let parts = block.inputs.iter().filter_map(|input| Some((input, block.in_set(input)?)));
    let mut events = Vec::new();
    for (input, part) in parts {
        events.push(Event::new(&input.path, "0", 0, 5, 45_000));
        match part {
            "set_id" => {
                events.push(Event::new(&input.path, "0", 3_000, 2, 26_000));
                events.push(Event::new(&input.path, "1", 6_500, 300, 24_000));
                events.push(Event::new(&input.path, "7", 30_000, 700, 34_000));
            }
            "limit" => events.push(Event::new(&input.path, "nan", 30_000, 700, 34_000)),
            _ => {}
        }
    }
    events
}
