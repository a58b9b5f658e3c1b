//! The engine `reference`: the Rust source itself.

use super::answers;
use crate::samples::Samples;
use generator::blocks::{self, Block, Designed};
use portable::Literal;

/// One cycle of a block: from its inputs to its outputs.
pub type Cycle = Box<dyn FnMut(&[Literal], &mut Vec<Literal>)>;

/// A block before its first cycle.
///
/// # Panics
/// If the axis does not have the block.
#[must_use]
pub fn start(designed: &Designed, block: &Block) -> Cycle {
    let kind = blocks::named(block.program.block).expect("engine: the axis has the block");
    let mut reference = kind.start(designed);
    Box::new(move |inputs, outputs| reference.step(inputs, outputs))
}

pub fn run(designed: &Designed, block: &Block, inputs: &Samples) -> Samples {
    answers(block, inputs, start(designed, block))
}
