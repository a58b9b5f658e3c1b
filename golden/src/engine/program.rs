//! The engine `program`: the specialised program, interpreted.

use super::answers;
use crate::samples::Samples;
use compiler::interp::Machine;
use generator::blocks::Block;

pub fn run(block: &Block, inputs: &Samples) -> Samples {
    let mut machine = Machine::start(&block.program);
    answers(block, inputs, |values, outputs| machine.step(values, outputs))
}
