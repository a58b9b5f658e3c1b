//! Small blocks and their samples.

use compiler::program::Type;
use golden::engine::st::{Block, Dialect, Mistake};
use golden::samples::{Samples, Shape, Signal};
use portable::{Literal, RealKind};

/// The mistakes of a text.
pub fn said(dialect: Dialect, text: &str, name: &str, real: RealKind) -> Vec<String> {
    let mistakes = Block::read(dialect, text, name, real).err().unwrap_or_default();
    mistakes.iter().map(Mistake::to_string).collect()
}

/// The block of a text that has no mistakes.
pub fn block(dialect: Dialect, text: &str, name: &str, real: RealKind) -> Block {
    Block::read(dialect, text, name, real).unwrap_or_else(|mistakes| {
        let said: Vec<String> = mistakes.iter().map(Mistake::to_string).collect();
        panic!("{}\n{text}", said.join("\n"))
    })
}

/// Signals by their names and types.
pub fn shape(real: RealKind, signals: &[(&str, Type)]) -> Shape {
    let start = |ty| match (ty, real) {
        (Type::Bool, _) => Literal::Bool(false),
        (Type::I32, _) => Literal::I32(0),
        (Type::U32, _) => Literal::U32(0),
        (Type::Real, RealKind::F64) => Literal::F64(0.0),
        (Type::Real, RealKind::F32) => Literal::F32(0.0),
    };
    let signal = |&(name, ty): &(&str, Type)| Signal { name: name.to_owned(), ty, start: start(ty) };
    Shape { real, signals: signals.iter().map(signal).collect() }
}

/// The names of the signals.
pub fn names(shape: &Shape) -> Vec<String> {
    shape.signals.iter().map(|signal| signal.name.clone()).collect()
}

/// What a block answers to samples.
pub fn answers(block: &Block, inputs: &Samples, outputs: &Shape, set: &[(&str, bool)]) -> Vec<Vec<Literal>> {
    let run = block.run(inputs, &names(&inputs.shape), outputs, &names(outputs), set);
    let run = run.unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    assert_eq!(run.len(), inputs.len());
    (0..run.len())
        .map(|sample| {
            let mut values = Vec::new();
            run.read(sample, &mut values);
            values
        })
        .collect()
}
