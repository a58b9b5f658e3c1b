//! Runs as CSV: a header of signal names, one row a cycle, reals in decimal or as the hexadecimal digits of their bits.

use crate::samples::{Samples, Shape, Signal};
use compiler::program::Type;
use portable::{Literal, RealKind};
use std::fmt::Write;

/// How reals are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reals {
    /// the shortest decimal that reads back to the same bits
    Decimal,
    /// `0x` and 16 digits (f32: 8)
    Hexadecimal,
}

/// Writes runs of the same length side by side.
#[must_use]
pub fn write(runs: &[&Samples], reals: Reals) -> String {
    let mut text = String::new();
    let names = runs.iter().flat_map(|run| run.shape.signals.iter().map(|signal| signal.name.as_str()));
    text.push_str(&names.collect::<Vec<_>>().join(","));
    text.push('\n');
    let mut values = Vec::new();
    for sample in 0..runs.first().map_or(0, |run| run.len()) {
        let mut separator = "";
        for run in runs {
            run.read(sample, &mut values);
            for value in &values {
                text.push_str(separator);
                cell(*value, reals, &mut text);
                separator = ",";
            }
        }
        text.push('\n');
    }
    text
}

/// One value as a cell.
///
/// # Panics
/// If the value exists only while specialising.
pub fn cell(value: Literal, reals: Reals, text: &mut String) {
    let written = match (value, reals) {
        (Literal::Bool(value), _) => write!(text, "{}", u8::from(value)),
        (Literal::I32(value), _) => write!(text, "{value}"),
        (Literal::U32(value), _) => write!(text, "{value}"),
        (Literal::F64(value), Reals::Hexadecimal) => write!(text, "0x{:016x}", value.to_bits()),
        (Literal::F32(value), Reals::Hexadecimal) => write!(text, "0x{:08x}", value.to_bits()),
        (Literal::F64(value), Reals::Decimal) => write!(text, "{value:?}"),
        (Literal::F32(value), Reals::Decimal) => write!(text, "{value:?}"),
        (Literal::Usize(_) | Literal::Variant(_), _) => panic!("csv: {value:?} is no signal"),
    };
    written.expect("csv: a string takes all text");
}

/// What is wrong with a CSV file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// the line, counted from 1
    pub line: usize,
    /// the column in characters, counted from 1
    pub column: usize,
    /// what was found
    pub found: String,
    /// what is allowed
    pub allowed: String,
}

/// Reads a run of these signals. A signal without a column keeps its start.
///
/// # Errors
/// All mistakes, in the order of the lines: unknown or repeated columns, short or long rows, bad cells.
pub fn read(text: &str, shape: &Shape) -> Result<Samples, Vec<Mistake>> {
    let mut lines = text.lines().enumerate();
    let header = lines.next().map_or("", |(_, line)| line);
    let columns = columns(header, shape)?;
    let mut samples = Samples::with_capacity(shape.clone(), text.len() / (2 * shape.signals.len().max(1)));
    let start: Vec<Literal> = shape.signals.iter().map(|signal| signal.start).collect();
    let mut values = start.clone();
    let mut mistakes = Vec::new();
    for (index, line) in lines {
        let number = index + 1;
        let cells = line.split(',').count();
        if cells != columns.len() {
            mistakes.push(Mistake {
                line: number,
                column: 1,
                found: format!("{cells} cells"),
                allowed: format!("{} cells, as many as the header has columns", columns.len()),
            });
            continue;
        }
        values.copy_from_slice(&start);
        let mut column = 1;
        for (content, signal) in line.split(',').zip(&columns) {
            match parse(content.trim(), &shape.signals[*signal], shape.real) {
                Some(value) => values[*signal] = value,
                None => mistakes.push(Mistake {
                    line: number,
                    column,
                    found: format!("`{}` for {}", content.escape_default(), shape.signals[*signal].name),
                    allowed: allowed(shape.signals[*signal].ty, shape.real).to_owned(),
                }),
            }
            column += content.chars().count() + 1;
        }
        samples.push(&values);
    }
    if mistakes.is_empty() { Ok(samples) } else { Err(mistakes) }
}

/// A run that was recorded elsewhere: what went into the block, and what came out as far as it was recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// all inputs
    pub inputs: Samples,
    /// the outputs that have a column
    pub outputs: Samples,
    /// their positions among the outputs of the block
    pub recorded: Vec<usize>,
}

/// Reads a recording: columns of inputs and outputs in any order. An input without a column keeps its start.
///
/// # Errors
/// All mistakes; that there is no column of an output is one.
pub fn read_recording(text: &str, inputs: &Shape, outputs: &Shape) -> Result<Recording, Vec<Mistake>> {
    let both = Shape { real: inputs.real, signals: [inputs.signals.as_slice(), &outputs.signals].concat() };
    let header = text.lines().next().unwrap_or_default();
    let found = columns(header, &both)?;
    let first_output = inputs.signals.len();
    let mut recorded: Vec<usize> = found.into_iter().filter_map(|signal| signal.checked_sub(first_output)).collect();
    recorded.sort_unstable();
    if recorded.is_empty() {
        let allowed = outputs.signals.iter().map(|signal| signal.name.as_str()).collect::<Vec<_>>().join(", ");
        let found = "no column of an output, so that there is nothing to compare".to_owned();
        return Err(vec![Mistake { line: 1, column: 1, found, allowed }]);
    }
    let samples = read(text, &both)?;
    let of_outputs: Vec<usize> = recorded.iter().map(|signal| first_output + signal).collect();
    Ok(Recording {
        inputs: samples.only(&(0..first_output).collect::<Vec<_>>()),
        outputs: samples.only(&of_outputs),
        recorded,
    })
}

/// The signal of each column.
fn columns(header: &str, shape: &Shape) -> Result<Vec<usize>, Vec<Mistake>> {
    let (mut columns, mut mistakes, mut column) = (Vec::new(), Vec::new(), 1);
    for name in header.split(',') {
        let signal = shape.signals.iter().position(|signal| signal.name == name.trim());
        match signal {
            Some(signal) if !columns.contains(&signal) => columns.push(signal),
            found => mistakes.push(Mistake {
                line: 1,
                column,
                found: format!(
                    "the column `{}`{}",
                    name.escape_default(),
                    if found.is_some() { " a second time" } else { "" }
                ),
                allowed: shape.signals.iter().map(|signal| signal.name.as_str()).collect::<Vec<_>>().join(", "),
            }),
        }
        column += name.chars().count() + 1;
    }
    if mistakes.is_empty() { Ok(columns) } else { Err(mistakes) }
}

/// The value of a cell.
#[must_use]
pub fn parse(cell: &str, signal: &Signal, real: RealKind) -> Option<Literal> {
    match (signal.ty, real) {
        (Type::Bool, _) => match cell {
            "0" | "FALSE" | "false" => Some(Literal::Bool(false)),
            "1" | "TRUE" | "true" => Some(Literal::Bool(true)),
            _ => None,
        },
        (Type::I32, _) => cell.parse().ok().map(Literal::I32),
        (Type::U32, _) => cell.parse().ok().map(Literal::U32),
        (Type::Real, RealKind::F64) => match cell.strip_prefix("0x") {
            Some(digits) if digits.len() == 16 => {
                u64::from_str_radix(digits, 16).ok().map(|bits| Literal::F64(f64::from_bits(bits)))
            }
            Some(_) => None,
            None => cell.parse().ok().map(Literal::F64),
        },
        (Type::Real, RealKind::F32) => match cell.strip_prefix("0x") {
            Some(digits) if digits.len() == 8 => {
                u32::from_str_radix(digits, 16).ok().map(|bits| Literal::F32(f32::from_bits(bits)))
            }
            Some(_) => None,
            None => cell.parse().ok().map(Literal::F32),
        },
    }
}

fn allowed(ty: Type, real: RealKind) -> &'static str {
    match (ty, real) {
        (Type::Bool, _) => "0 or 1",
        (Type::I32, _) => "an integer from -2147483648 to 2147483647",
        (Type::U32, _) => "an integer from 0 to 4294967295",
        (Type::Real, RealKind::F64) => "a decimal number, or 0x and 16 hexadecimal digits",
        (Type::Real, RealKind::F32) => "a decimal number, or 0x and 8 hexadecimal digits",
    }
}
