//! The engines `st`, `twincat` and `codesys`: the emitted Structured Text, read by a grammar that is not ours, and run.

use super::Failure;
use super::st::{self, Dialect, Mistake};
use crate::samples::{Samples, Shape};
use compiler::print::{signals, st::PLAIN};
use generator::axis::Axis;
use generator::block::Block;
use generator::target::block_name;

/// Runs one of an axis's blocks from the file that the target of a dialect emits.
pub fn run(
    dialect: Dialect,
    axis: &Axis,
    blocks: &[Block],
    which: usize,
    inputs: &Samples,
) -> Result<Samples, Failure> {
    let block = &blocks[which];
    let name = block_name(&axis.name, block.program.block);
    let (target, blocks, name, enable): (_, _, _, &[(&str, bool)]) = match dialect {
        Dialect::Plain => ("st", blocks, name, &[]),
        // A file for each block.
        Dialect::TwinCat => ("twincat", std::slice::from_ref(block), format!("FB_{name}"), &[("Enable", true)]),
        Dialect::Codesys => ("codesys", blocks, name, &[]),
    };
    let files = super::files(target, axis, blocks)?;
    let file = files.first().expect("engine: every target emits the block first");
    let broken = |mistakes: Vec<Mistake>| {
        let lines: Vec<String> = mistakes.iter().map(|mistake| format!("{}:{mistake}", file.name)).collect();
        Failure::Broken(lines.join("\n"))
    };
    let [input_names, output_names] = signals(&block.program, &PLAIN);
    let outputs = Shape::of(&block.program.outputs, block.program.real);
    let read = st::Block::read(dialect, &file.text, &name, block.program.real).map_err(broken)?;
    read.run(inputs, &input_names, &outputs, &output_names, enable).map_err(broken)
}
