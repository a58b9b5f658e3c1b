//! Runs as CSV: a header of signal names, one row per cycle, reals in decimal or as the hexadecimal digits of their bits.

use crate::mistake::Mistake;
use crate::samples::{Samples, Shape};
use crate::series;
use crate::signals;
use crate::table::Table;
use portable::Literal;
use std::fmt::Write;

/// The notation of reals.
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
        (Literal::Usize(_) | Literal::Variant(_), _) => panic!("csv: {value:?} is not a signal"),
    };
    written.expect("csv: a string takes all text");
}

/// Reads a run of these signals. A signal without a column keeps its start value.
///
/// # Errors
/// All errors, in the order of the lines: unknown or repeated columns, short or long rows, bad cells.
pub fn read(text: &str, shape: &Shape) -> Result<Samples, Vec<Mistake>> {
    let table = Table::read(text, &[]);
    let signals = signals::of_columns(&table, shape, &[], &[])?;
    series::read(&table, &signals, shape, None).map(|columns| columns.samples)
}
