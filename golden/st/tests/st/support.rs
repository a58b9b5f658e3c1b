//! Small blocks, their signals and their samples.

use portable::{Literal, RealKind};
use st::{Block, Dialect, Mistake, Signal};

/// A real of an LREAL block, for the type of a signal.
pub const LREAL: Literal = Literal::F64(0.0);

/// The mistakes of a text.
pub fn said(dialect: Dialect, text: &str, name: &str, real: RealKind) -> Vec<String> {
    said_with(dialect, text, name, real, &[])
}

/// The mistakes of a text that may have instances of others.
pub fn said_with(dialect: Dialect, text: &str, name: &str, real: RealKind, others: &[Block]) -> Vec<String> {
    let mistakes = Block::read_with(dialect, text, name, real, others).err().unwrap_or_default();
    mistakes.iter().map(Mistake::to_string).collect()
}

/// The block of a text that has no mistakes.
pub fn block(dialect: Dialect, text: &str, name: &str, real: RealKind) -> Block {
    block_with(dialect, text, name, real, &[])
}

/// The block of a text that has no mistakes and may have instances of others.
pub fn block_with(dialect: Dialect, text: &str, name: &str, real: RealKind, others: &[Block]) -> Block {
    Block::read_with(dialect, text, name, real, others).unwrap_or_else(|mistakes| {
        let said: Vec<String> = mistakes.iter().map(Mistake::to_string).collect();
        panic!("{}\n{text}", said.join("\n"))
    })
}

/// What a block answers to samples.
pub fn answers(
    block: &Block,
    inputs: &[Signal<'_>],
    samples: &[Vec<Literal>],
    outputs: &[Signal<'_>],
    set: &[(&str, bool)],
) -> Vec<Vec<Literal>> {
    let mut instance = block.start(inputs, outputs, set).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    let answer = |sample: &Vec<Literal>| {
        let mut values = Vec::new();
        instance.cycle(sample, &mut values);
        values
    };
    samples.iter().map(answer).collect()
}
