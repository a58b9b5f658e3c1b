//! The engine `reference`: the Rust source itself.

use crate::samples::{Samples, Shape};
use generator::blocks::Designed;
use generator::blocks::{self, Block};
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

/// Runs a block.
pub fn run(designed: &Designed, block: &Block, inputs: &Samples) -> Samples {
    let shape = Shape::of(&block.program.outputs, block.program.real);
    let mut samples = Samples::with_capacity(shape, inputs.len());
    let (mut cycle, mut values, mut outputs) = (start(designed, block), Vec::new(), Vec::new());
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut values);
        cycle(&values, &mut outputs);
        samples.push(&outputs);
    }
    samples
}
