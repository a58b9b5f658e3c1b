//! The Structured Text of a batch: each block read and run by the engine `st`, several files at a time.

use super::compile::Line;
use compiler::program::Type;
use golden::engine::st::{Block, Dialect};
use golden::samples::{Samples, Shape, Signal};
use inside::judge::same;
use portable::{Literal, RealKind};
use rayon::prelude::*;
use std::fs;
use std::path::Path;

/// Runs the files of a folder that begin with the programs of these numbers.
///
/// # Errors
/// A file is not there or not as it must be.
pub fn run(folder: &Path, firsts: &[usize]) -> Result<Vec<Line>, String> {
    let files: Vec<_> = firsts.iter().flat_map(|first| ["f64", "f32"].map(|real| (real, *first))).collect();
    let lines: Result<Vec<_>, String> = files.into_par_iter().map(|(real, first)| file(folder, real, first)).collect();
    Ok(lines?.concat())
}

fn file(folder: &Path, real: &'static str, first: usize) -> Result<Vec<Line>, String> {
    let stem = folder.join(format!("{real}_{first}"));
    let read = |extension: &str| {
        let path = stem.with_extension(extension);
        fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))
    };
    let text = |extension: &str| read(extension).map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    let (source, signals, answers) = (text("st")?, text("signals")?, read("answers")?);
    let mut words =
        answers.chunks_exact(8).map(|word| word.iter().rev().fold(0, |all, byte| all << 8 | u64::from(*byte)));
    let mut blocks = source.split_inclusive("END_FUNCTION_BLOCK\n");
    let mut lines = Vec::new();
    for line in signals.lines() {
        let subject = Subject::of(line, real).ok_or_else(|| format!("{}: `{line}`", stem.display()))?;
        let program = subject.number;
        let block = blocks.next().unwrap_or_default();
        let found = subject.differs(block, &mut words);
        lines.extend(found.map(|message| Line { program, real, engine: "st".to_owned(), message }));
    }
    Ok(lines)
}

/// A block with its signals.
struct Subject {
    number: usize,
    real: RealKind,
    inputs: Shape,
    outputs: Shape,
}

impl Subject {
    fn of(line: &str, real: &str) -> Option<Self> {
        let [number, inputs, outputs] = line.split(';').collect::<Vec<_>>().try_into().ok()?;
        let real = if real == "f64" { RealKind::F64 } else { RealKind::F32 };
        let shape = |list: &str| {
            let signals: Option<Vec<Signal>> = list.split_whitespace().map(|signal| of_signal(signal, real)).collect();
            Some(Shape { real, signals: signals? })
        };
        Some(Self { number: number.parse().ok()?, real, inputs: shape(inputs)?, outputs: shape(outputs)? })
    }

    /// Runs all runs; tells where the block's answers are not those of the words.
    fn differs(&self, block: &str, words: &mut impl Iterator<Item = u64>) -> Option<String> {
        let mut next = || words.next().unwrap_or_default();
        let (runs, samples) = (next(), next());
        let names = |shape: &Shape| shape.signals.iter().map(|signal| signal.name.clone()).collect::<Vec<_>>();
        let read = Block::read(Dialect::Plain, block, &format!("p{}", self.number), self.real);
        let mut difference = read.as_ref().err().map(|mistakes| mistakes.iter().map(|it| format!("{it}; ")).collect());
        for run in 0..runs {
            let (mut inputs, mut answers) = (Samples::with_capacity(self.inputs.clone(), 0), Vec::new());
            for _ in 0..samples {
                inputs.push(&self.inputs.signals.iter().map(|signal| value(next(), signal)).collect::<Vec<_>>());
                answers.push(self.outputs.signals.iter().map(|signal| value(next(), signal)).collect::<Vec<_>>());
            }
            let Ok(block) = &read else { continue };
            // A block without inputs has no samples that say how many there are.
            if difference.is_some() || self.inputs.signals.is_empty() {
                continue;
            }
            match block.run(&inputs, &names(&self.inputs), &self.outputs, &names(&self.outputs), &[]) {
                Ok(found) => difference = self.first(run, &answers, &found),
                Err(mistakes) => difference = Some(format!("{mistakes:?}")),
            }
        }
        difference
    }

    /// The first value that differs.
    fn first(&self, run: u64, answers: &[Vec<Literal>], found: &Samples) -> Option<String> {
        let mut values = Vec::new();
        answers.iter().enumerate().find_map(|(sample, answer)| {
            found.read(sample, &mut values);
            let at = values.iter().zip(answer).position(|(found, expected)| !same(*found, *expected))?;
            let name = &self.outputs.signals[at].name;
            Some(format!("run {run}, sample {sample}: {name} is {:?}, in Rust it is {:?}", values[at], answer[at]))
        })
    }
}

fn of_signal(text: &str, real: RealKind) -> Option<Signal> {
    let (name, ty) = text.split_once(':')?;
    let (ty, start) = match (ty, real) {
        ("Bool", _) => (Type::Bool, Literal::Bool(false)),
        ("I32", _) => (Type::I32, Literal::I32(0)),
        ("U32", _) => (Type::U32, Literal::U32(0)),
        ("Real", RealKind::F64) => (Type::Real, Literal::F64(0.0)),
        ("Real", RealKind::F32) => (Type::Real, Literal::F32(0.0)),
        _ => return None,
    };
    Some(Signal { name: name.to_owned(), ty, start })
}

/// The value of a word.
fn value(word: u64, signal: &Signal) -> Literal {
    let [a, b, c, d, ..] = word.to_le_bytes();
    let half = u32::from_le_bytes([a, b, c, d]);
    match signal.start {
        Literal::Bool(_) => Literal::Bool(word != 0),
        Literal::I32(_) => Literal::I32(half.cast_signed()),
        Literal::F64(_) => Literal::F64(f64::from_bits(word)),
        Literal::F32(_) => Literal::F32(f32::from_bits(half)),
        _ => Literal::U32(half),
    }
}
