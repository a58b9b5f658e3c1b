//! A run that was recorded on a controller, and how far what an engine gives agrees with it.

use crate::csv::{Mistake, samples, signals};
use crate::samples::{Samples, Shape};
use crate::table::Table;
use compiler::program::Type;
use portable::Extreme;
use portable::{Literal, RealKind};

/// What went into the block, and what came out as far as it was recorded.
#[derive(Clone, Debug)]
pub struct Recording {
    /// all inputs
    pub inputs: Samples,
    /// the outputs that have a column
    pub outputs: Samples,
    /// their positions among the outputs of the block
    pub recorded: Vec<usize>,
    /// the columns that are no signal of the block
    pub left_out: Vec<String>,
    /// the line of each sample, counted from 1
    pub lines: Vec<usize>,
    /// how the inputs were written, in their order
    pub input_precision: Vec<Precision>,
    /// how the outputs were written that have a column
    pub output_precision: Vec<Precision>,
}

/// How many digits of the values of a column were written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Precision {
    /// the most significant digits of a value; 0: all are there, or there is no column
    pub digits: usize,
    /// the most digits behind the point
    decimals: i32,
}

/// How the values of one signal differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Error {
    /// the largest difference; infinite: one of the values is no number
    pub largest: f64,
    /// the sample in which it is
    pub sample: usize,
    /// whether the digits that were written explain all differences
    pub is_explained: bool,
}

/// Reads a recording: columns of inputs and outputs in any order; `map` says which column is which signal, where the names do not.
/// An input without a column keeps its start.
///
/// # Errors
/// All mistakes; that there is no column of an output is one, another sample time than the cycle time is one.
pub fn read(
    text: &str,
    [inputs, outputs]: [&Shape; 2],
    map: &[(String, String)],
    cycle_time_ns: u32,
) -> Result<Recording, Vec<Mistake>> {
    let both = Shape { real: inputs.real, signals: [inputs.signals.as_slice(), &outputs.signals].concat() };
    let table = Table::read(text);
    let found = signals(&table, &both, map)?;
    let first_output = inputs.signals.len();
    let mut recorded: Vec<usize> =
        found.iter().flatten().filter_map(|signal| signal.checked_sub(first_output)).collect();
    recorded.sort_unstable();
    if recorded.is_empty() {
        let allowed = outputs.signals.iter().map(|signal| signal.name.as_str()).collect::<Vec<_>>().join(", ");
        let found = "no column of an output, so that there is nothing to compare".to_owned();
        return Err(vec![Mistake { line: 1, column: 1, found, allowed }]);
    }
    sample_times(&table, &found, cycle_time_ns)?;
    let all = samples(&table, &found, &both)?;
    let precision = precisions(&table, &found, &both);
    let of_outputs: Vec<usize> = recorded.iter().map(|signal| first_output + signal).collect();
    let left_out = table.columns.iter().zip(&found).filter(|(_, signal)| signal.is_none());
    Ok(Recording {
        inputs: all.only(&(0..first_output).collect::<Vec<_>>()),
        outputs: all.only(&of_outputs),
        left_out: left_out.map(|(column, _)| column.name.to_owned()).collect(),
        lines: table.rows.iter().map(|row| row.line).collect(),
        input_precision: precision[..first_output].to_vec(),
        output_precision: of_outputs.iter().map(|signal| precision[*signal]).collect(),
        recorded,
    })
}

/// A sample is one cycle of the block.
fn sample_times(table: &Table<'_>, signals: &[Option<usize>], cycle_time_ns: u32) -> Result<(), Vec<Mistake>> {
    let cycle = f64::from(cycle_time_ns) / 1e6;
    let recorded = table.columns.iter().zip(signals).filter(|(_, signal)| signal.is_some());
    let wrong = recorded.filter_map(|(column, _)| column.sample_time).filter(|(text, _)| {
        let time = text.replace(',', ".").parse::<f64>();
        time.is_ok_and(|time| (time - cycle).abs() > 1e-6 * cycle)
    });
    let mistakes: Vec<Mistake> = wrong
        .map(|(text, [line, column])| Mistake {
            line,
            column,
            found: format!("a sample every {text} ms, the block runs every {cycle} ms"),
            allowed: "a recording of every cycle of the block".to_owned(),
        })
        .collect();
    if mistakes.is_empty() { Ok(()) } else { Err(mistakes) }
}

/// How the values of each signal were written.
fn precisions(table: &Table<'_>, signals: &[Option<usize>], shape: &Shape) -> Vec<Precision> {
    let mut all = vec![Precision::default(); shape.signals.len()];
    for row in &table.rows {
        for ((_, cell), signal) in table.cells(row).into_iter().flatten().zip(signals) {
            if let Some(signal) = signal.filter(|signal| shape.signals[*signal].ty == Type::Real) {
                let (digits, decimals) = written(&cell);
                let precision = &mut all[signal];
                precision.digits = precision.digits.max(digits);
                precision.decimals = precision.decimals.max(decimals);
            }
        }
    }
    let full = match shape.real {
        RealKind::F64 => 16,
        RealKind::F32 => 8,
    };
    all.into_iter().map(|precision| if precision.digits > full { Precision::default() } else { precision }).collect()
}

/// Significant digits and digits behind the point of a number as it was written; all of them if it is written in bits.
fn written(cell: &str) -> (usize, i32) {
    if cell.starts_with("0x") {
        return (usize::MAX, 0);
    }
    let (mantissa, exponent) = cell.split_once(['e', 'E']).unwrap_or((cell, "0"));
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).skip_while(|digit| *digit == b'0').count();
    let behind = mantissa.split_once('.').map_or(0, |(_, behind)| behind.len());
    (digits, i32::try_from(behind).unwrap_or(0) - exponent.parse::<i32>().unwrap_or(0))
}

impl Precision {
    /// What the last digit of a value was worth when it was written.
    fn unit(self, value: f64) -> f64 {
        let digits = i32::try_from(self.digits).unwrap_or(0);
        match self.digits {
            0 => 0.0,
            _ if value == 0.0 || !value.is_finite() => libm::pow(10.0, f64::from(-self.decimals)),
            _ => {
                let first = libm::floor(libm::log10(value.abs()));
                libm::pow(10.0, (first + f64::from(1 - digits)).larger(f64::from(-self.decimals)))
            }
        }
    }
}

impl Recording {
    /// Inputs that would have been written the same: each real is moved by half of what its last digit was worth, up or down.
    /// `None`: the inputs are exact, or all outputs are, so that nothing excuses an error of theirs.
    #[must_use]
    pub fn moved_inputs(&self) -> Option<Samples> {
        let is_rounded = |precision: &[Precision]| precision.iter().any(|precision| precision.digits > 0);
        if !is_rounded(&self.input_precision) || !is_rounded(&self.output_precision) {
            return None;
        }
        let mut moved = Samples::with_capacity(self.inputs.shape.clone(), self.inputs.len());
        let (mut values, mut noise) = (Vec::new(), 1u64);
        for sample in 0..self.inputs.len() {
            self.inputs.read(sample, &mut values);
            for (value, precision) in values.iter_mut().zip(&self.input_precision) {
                noise = noise.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let half = if noise >> 63 == 0 { 0.5 } else { -0.5 };
                match value {
                    Literal::F64(value) => *value += half * precision.unit(*value),
                    #[expect(clippy::cast_possible_truncation, reason = "single precision is what the block reads")]
                    Literal::F32(value) => *value += (half * precision.unit(f64::from(*value))) as f32,
                    _ => {}
                }
            }
            moved.push(&values);
        }
        Some(moved)
    }

    /// How the recorded outputs differ from those that an engine gives; `moved` are those for moved inputs. An error is explained
    /// by half of what the last digit was worth, together with twice what the moved inputs change at the most.
    #[must_use]
    pub fn errors(&self, computed: &Samples, moved: Option<&Samples>) -> Vec<Error> {
        let signals = 0..self.recorded.len();
        let change =
            moved.map(|moved| signals.clone().map(|signal| changes(computed, moved, signal)).collect::<Vec<_>>());
        let of = |signal: usize| {
            let allowance = change.as_ref().map_or(0.0, |change| 2.0 * change[signal]);
            let mut error = Error { largest: 0.0, sample: 0, is_explained: true };
            for (sample, [recorded, computed]) in pairs(&self.outputs, computed, signal) {
                let difference = apart(recorded, computed);
                let unit = number(recorded).map_or(0.0, |value| self.output_precision[signal].unit(value));
                // Of a real whose bits were recorded nothing explains a difference.
                let is_written_so = unit > 0.0 || matches!(recorded, Literal::I32(_));
                let is_near = difference <= (0.5 * unit + allowance) * (1.0 + 1e-12);
                error.is_explained &= recorded == computed || is_written_so && is_near;
                if difference > error.largest {
                    error = Error { largest: difference, sample, ..error };
                }
            }
            error
        };
        signals.map(of).collect()
    }
}

/// The largest difference between two runs in a signal.
fn changes(a: &Samples, b: &Samples, signal: usize) -> f64 {
    pairs(a, b, signal).map(|(_, [a, b])| apart(a, b)).fold(0.0, f64::larger)
}

/// The values of a signal in the samples that both runs have.
fn pairs<'s>(a: &'s Samples, b: &'s Samples, signal: usize) -> impl Iterator<Item = (usize, [Literal; 2])> + 's {
    let (mut of_a, mut of_b) = (Vec::new(), Vec::new());
    (0..a.len().min(b.len())).map(move |sample| {
        a.read(sample, &mut of_a);
        b.read(sample, &mut of_b);
        (sample, [of_a[signal], of_b[signal]])
    })
}

/// How far two values lie apart; infinitely, if they differ and are no two numbers.
fn apart(a: Literal, b: Literal) -> f64 {
    if a == b {
        return 0.0;
    }
    match (number(a), number(b)) {
        (Some(a), Some(b)) if !(a - b).is_nan() => (a - b).abs(),
        _ => f64::INFINITY,
    }
}

fn number(value: Literal) -> Option<f64> {
    match value {
        Literal::F64(value) => Some(value),
        Literal::F32(value) => Some(f64::from(value)),
        Literal::I32(value) => Some(f64::from(value)),
        _ => None,
    }
}
