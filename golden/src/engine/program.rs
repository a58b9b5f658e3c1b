//! The engine `program`: the specialised program, interpreted.

use crate::samples::{Samples, Shape};
use compiler::interp::Machine;
use generator::blocks::Block;

/// Runs a block.
pub fn run(block: &Block, inputs: &Samples) -> Samples {
    let shape = Shape::of(&block.program.outputs, block.program.real);
    let mut samples = Samples::with_capacity(shape, inputs.len());
    let mut machine = Machine::start(&block.program);
    let (mut values, mut outputs) = (Vec::new(), Vec::new());
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut values);
        machine.step(&values, &mut outputs);
        samples.push(&outputs);
    }
    samples
}
