//! The engines `st`, `twincat` and `codesys`: the emitted Structured Text, read by a grammar that is not ours, and run.

use super::Failure;
use super::st::{self, Dialect, Mistake};
use crate::samples::{Samples, Shape};
use generator::blocks::Block;
use generator::blocks::Designed;
use generator::target::names::Names;
use generator::target::st::names::{is_reserved, signals};
use generator::target::st::{codesys, plain, twincat};
use generator::target::{File, block_name};

/// Runs one of an axis's blocks from the file that the target of a dialect emits.
pub fn run(
    dialect: Dialect,
    designed: &Designed,
    blocks: &[Block],
    which: usize,
    inputs: &Samples,
) -> Result<Samples, Failure> {
    let (axis, block) = (&designed.axis, &blocks[which]);
    let (files, name, enable): (Vec<File>, _, &[(&str, bool)]) = match dialect {
        Dialect::Plain => (plain::files(axis, blocks), block_name(&axis.name, block.program.block), &[]),
        Dialect::TwinCat => {
            let name = twincat::block_name(&axis.name, block.program.block);
            // A file for each block.
            (twincat::files(axis, std::slice::from_ref(block)), name, &[("Enable", true)])
        }
        Dialect::Codesys => (codesys::files(axis, blocks), block_name(&axis.name, block.program.block), &[]),
    };
    let file = files.first().expect("engine: every target emits the block first");
    let broken = |mistakes: Vec<Mistake>| {
        let lines: Vec<String> = mistakes.iter().map(|mistake| format!("{}:{mistake}", file.name)).collect();
        Failure::Broken(lines.join("\n"))
    };
    let [input_names, output_names] = signals(&block.program, &mut Names::without(is_reserved));
    let outputs = Shape::of(&block.program.outputs, block.program.real);
    let read = st::Block::read(dialect, &file.text, &name, block.program.real).map_err(broken)?;
    read.run(inputs, &input_names, &outputs, &output_names, enable).map_err(broken)
}
