//! The engine `reference`: the Rust source itself.

use crate::samples::{Samples, Shape};
use generator::blocks::Designed;
use generator::blocks::{self, Block};

/// Runs a block.
pub fn run(designed: &Designed, block: &Block, inputs: &Samples) -> Samples {
    let kind = blocks::named(block.program.block).expect("engine: the registry has every block");
    let shape = Shape::of(&block.program.outputs, block.program.real);
    let mut samples = Samples::with_capacity(shape, inputs.len());
    let (mut reference, mut values, mut outputs) = (kind.start(designed), Vec::new(), Vec::new());
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut values);
        reference.step(&values, &mut outputs);
        samples.push(&outputs);
    }
    samples
}
