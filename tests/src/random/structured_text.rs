//! The Structured Text of a batch: each block read and run by the engine `st`, several files at a time.

use super::compile::Line;
use inside::judge::same;
use portable::{Literal, RealKind};
use rayon::prelude::*;
use st::{Block, Dialect, Signal};
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
        let subject = Subject::read(line, real).ok_or_else(|| format!("{}: `{line}`", stem.display()))?;
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
    inputs: Vec<(String, Literal)>,
    outputs: Vec<(String, Literal)>,
}

impl Subject {
    fn read(line: &str, real: &str) -> Option<Self> {
        let [number, inputs, outputs] = line.split(';').collect::<Vec<_>>().try_into().ok()?;
        let real = if real == "f64" { RealKind::F64 } else { RealKind::F32 };
        let signals = |list: &str| list.split_whitespace().map(|text| signal(text, real)).collect::<Option<Vec<_>>>();
        Some(Self { number: number.parse().ok()?, real, inputs: signals(inputs)?, outputs: signals(outputs)? })
    }

    /// Runs all runs; tells where the block's answers are not those of the words.
    fn differs(&self, block: &str, words: &mut impl Iterator<Item = u64>) -> Option<String> {
        let mut next = || words.next().unwrap_or_default();
        let (runs, samples) = (next(), next());
        let read = Block::read(Dialect::Plain, block, &format!("p{}", self.number), self.real);
        let (inputs, outputs) = (signals(&self.inputs), signals(&self.outputs));
        let start = || read.as_ref().map_err(Clone::clone).and_then(|block| block.start(&inputs, &outputs, &[]));
        let mut difference = start().err().map(|mistakes| mistakes.iter().map(|it| format!("{it}; ")).collect());
        for run in 0..runs {
            let (mut instance, mut found) = (start().ok(), Vec::new());
            for sample in 0..samples {
                let mut values = |signals: &[(String, Literal)]| -> Vec<Literal> {
                    signals.iter().map(|(_, of)| value(next(), *of)).collect()
                };
                let (inputs, answers) = (values(&self.inputs), values(&self.outputs));
                let Some(instance) = &mut instance else { continue };
                instance.cycle(&inputs, &mut found);
                if difference.is_none() {
                    difference = self.first((run, sample), &answers, &found);
                }
            }
        }
        difference
    }

    /// The first value that differs.
    fn first(&self, (run, sample): (u64, u64), answers: &[Literal], found: &[Literal]) -> Option<String> {
        let at = found.iter().zip(answers).position(|(found, expected)| !same(*found, *expected))?;
        let (name, _) = &self.outputs[at];
        Some(format!("run {run}, sample {sample}: {name} is {:?}, in Rust it is {:?}", found[at], answers[at]))
    }
}

/// Signals as the engine takes them.
fn signals(list: &[(String, Literal)]) -> Vec<Signal<'_>> {
    list.iter().map(|(name, of)| (name.as_str(), *of)).collect()
}

/// A signal: its name, and a value of its type.
fn signal(text: &str, real: RealKind) -> Option<(String, Literal)> {
    let (name, ty) = text.split_once(':')?;
    let of = match (ty, real) {
        ("Bool", _) => Literal::Bool(false),
        ("I32", _) => Literal::I32(0),
        ("U32", _) => Literal::U32(0),
        ("Real", RealKind::F64) => Literal::F64(0.0),
        ("Real", RealKind::F32) => Literal::F32(0.0),
        _ => return None,
    };
    Some((name.to_owned(), of))
}

/// What a word is in the type of a value.
fn value(word: u64, of: Literal) -> Literal {
    let [a, b, c, d, ..] = word.to_le_bytes();
    let half = u32::from_le_bytes([a, b, c, d]);
    match of {
        Literal::Bool(_) => Literal::Bool(word != 0),
        Literal::I32(_) => Literal::I32(half.cast_signed()),
        Literal::F64(_) => Literal::F64(f64::from_bits(word)),
        Literal::F32(_) => Literal::F32(f32::from_bits(half)),
        _ => Literal::U32(half),
    }
}
