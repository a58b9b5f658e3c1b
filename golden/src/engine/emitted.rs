//! The engines `st`, `twincat`, `codesys` and `scl`: the emitted Structured Text, read by a grammar that is not ours, and run.

use super::Failure;
use crate::samples::{Samples, Shape};
use compiler::print::{signals, st::PLAIN};
use generator::blocks::{Block, Designed};
use generator::target::block_name;
use st::{Dialect, Mistake, Signal};

/// Runs one of an axis's blocks from the file that the target of a dialect emits.
pub fn run(
    dialect: Dialect,
    designed: &Designed,
    blocks: &[Block],
    which: usize,
    inputs: &Samples,
) -> Result<Samples, Failure> {
    let block = &blocks[which];
    let name = block_name(&designed.axis.name, block.program.block);
    let (target, blocks, name, enable): (_, _, _, &[(&str, bool)]) = match dialect {
        Dialect::Plain => ("st", blocks, name, &[]),
        // A file for each block.
        Dialect::TwinCat => ("twincat", std::slice::from_ref(block), format!("FB_{name}"), &[("Enable", true)]),
        Dialect::Codesys => ("codesys", blocks, name, &[]),
        // The blocks of Siemens's files have the names of TwinCAT's.
        Dialect::Scl => ("scl", blocks, format!("FB_{name}"), &[]),
    };
    let files = super::files(target, designed, blocks)?;
    let file = files.first().expect("engine: every target emits the block first");
    let broken = |mistakes: Vec<Mistake>| {
        let lines: Vec<String> = mistakes.iter().map(|mistake| format!("{}:{mistake}", file.name)).collect();
        Failure::Broken(lines.join("\n"))
    };
    let [input_names, output_names] = signals(&block.program, &PLAIN);
    let outputs = Shape::of(&block.program.outputs, block.program.real);
    let read = st::Block::read(dialect, &file.text, &name, block.program.real).map_err(broken)?;
    let mut instance = read
        .start(&signals_of(&inputs.shape, &input_names), &signals_of(&outputs, &output_names), enable)
        .map_err(broken)?;
    let mut answers = Samples::with_capacity(outputs, inputs.len());
    let (mut values, mut results) = (Vec::new(), Vec::new());
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut values);
        instance.cycle(&values, &mut results);
        answers.push(&results);
    }
    Ok(answers)
}

/// The signals of a shape under the names that they have in the text.
fn signals_of<'n>(shape: &Shape, names: &'n [String]) -> Vec<Signal<'n>> {
    shape.signals.iter().zip(names).map(|(signal, name)| (name.as_str(), signal.start)).collect()
}
