//! Runs as CSV: a header of signal names, one row a cycle, reals in decimal or as the hexadecimal digits of their bits.

use crate::samples::{Samples, Shape, Signal};
use crate::table::Table;
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
    let table = Table::read(text);
    let signals = signals(&table, shape, &[])?;
    samples(&table, &signals, shape)
}

/// The samples of a table in which each column is a signal, or is left out.
///
/// # Errors
/// All mistakes, in the order of the lines: short or long rows, bad cells.
pub(crate) fn samples(table: &Table<'_>, signals: &[Option<usize>], shape: &Shape) -> Result<Samples, Vec<Mistake>> {
    let mut samples = Samples::with_capacity(shape.clone(), table.rows.len());
    let start: Vec<Literal> = shape.signals.iter().map(|signal| signal.start).collect();
    let mut values = start.clone();
    let mut mistakes = Vec::new();
    for row in &table.rows {
        let cells = match table.cells(row) {
            Ok(cells) => cells,
            Err([found, right]) => {
                let allowed = format!("{right} cells, as many as the header has columns");
                mistakes.push(Mistake { line: row.line, column: 1, found: format!("{found} cells"), allowed });
                continue;
            }
        };
        values.copy_from_slice(&start);
        for ((column, content), signal) in cells.zip(signals) {
            let Some(signal) = *signal else { continue };
            match parse(&content, &shape.signals[signal], shape.real) {
                Some(value) => values[signal] = value,
                None => mistakes.push(Mistake {
                    line: row.line,
                    column,
                    found: format!("`{}` for {}", content.escape_default(), shape.signals[signal].name),
                    allowed: allowed(shape.signals[signal].ty, shape.real).to_owned(),
                }),
            }
        }
        samples.push(&values);
    }
    if mistakes.is_empty() { Ok(samples) } else { Err(mistakes) }
}

/// The signal of each column: as the map says, which has names of columns and of signals, else that of the same name, in an
/// export the same name behind a point. `None`: the column is left out, because the map gives it `-` or an export has it beside.
///
/// # Errors
/// All mistakes: unknown and repeated columns, what the map names and is not there.
pub(crate) fn signals(
    table: &Table<'_>,
    shape: &Shape,
    map: &[(String, String)],
) -> Result<Vec<Option<usize>>, Vec<Mistake>> {
    let position = |name: &str| shape.place(name);
    let names = || shape.signals.iter().map(|signal| signal.name.as_str()).collect::<Vec<_>>().join(", ");
    let (mut signals, mut mistakes) = (Vec::new(), Vec::new());
    for column in &table.columns {
        let mapped = map.iter().find(|(name, _)| name == column.name).map(|(_, signal)| signal.as_str());
        let last = column.name.rsplit('.').next().filter(|_| table.is_export);
        let signal = match mapped {
            Some(signal) => position(signal),
            None => position(column.name).or_else(|| last.and_then(position)),
        };
        let is_left_out = signal.is_none() && mapped.map_or(table.is_export, |signal| signal == "-");
        if !is_left_out && (signal.is_none() || signals.contains(&signal)) {
            let again = if signal.is_some() { " a second time" } else { "" };
            let found = match mapped {
                Some(signal) => format!("the column `{}` for `{signal}`{again}", column.name.escape_default()),
                None => format!("the column `{}`{again}", column.name.escape_default()),
            };
            let [line, column] = column.place;
            mistakes.push(Mistake { line, column, found, allowed: names() });
        }
        signals.push(signal);
    }
    for (name, _) in map.iter().filter(|(name, _)| table.columns.iter().all(|column| column.name != name)) {
        let allowed = table.columns.iter().map(|column| column.name).collect::<Vec<_>>().join(", ");
        let found = format!("no column `{}`, which --map names", name.escape_default());
        mistakes.push(Mistake {
            line: table.columns.first().map_or(1, |column| column.place[0]),
            column: 1,
            found,
            allowed,
        });
    }
    if mistakes.is_empty() { Ok(signals) } else { Err(mistakes) }
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
