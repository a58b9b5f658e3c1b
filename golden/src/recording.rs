//! A run recorded on a controller, and its agreement with the outputs of an engine.

use crate::mistake::Mistake;
use crate::samples::{Samples, Shape};
use crate::series;
use crate::signals::{self, Map};
use crate::table::{Column, Table};
use crate::written::Precision;
use compiler::arithmetic;
use compiler::program::Type;
use portable::{Extreme, Literal};

/// The inputs of the block, and its recorded outputs.
#[derive(Clone, Debug)]
pub struct Recording {
    pub inputs: Samples,
    /// the positions of the inputs with a column
    pub given: Vec<usize>,
    /// the outputs with a column
    pub outputs: Samples,
    /// their positions among the outputs of the block
    pub recorded: Vec<usize>,
    /// the columns that are not signals of the block
    pub left_out: Vec<String>,
    /// the columns whose first samples were left out, because another one begins later, and their number
    pub skipped: Vec<(String, usize)>,
    /// the line of each sample, counted from 1
    pub lines: Vec<usize>,
    /// the written precision of the inputs, in their order
    pub input_precision: Vec<Precision>,
    /// the written precision of the outputs with a column
    pub output_precision: Vec<Precision>,
}

/// The difference between the values of one signal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Error {
    /// the largest difference; infinite if one of the values is NaN
    pub largest: f64,
    /// the sample with the largest difference
    pub sample: usize,
    /// the first and the last sample with a difference that the written digits do not explain
    pub unexplained: Option<[usize; 2]>,
    /// the largest difference that these digits can explain
    pub allowance: f64,
    /// the largest recorded magnitude
    pub scale: f64,
}

/// Digits that explain more than this part of a signal prove nothing.
const VAGUE: f64 = 0.05;

impl Error {
    /// Whether the written digits explain differences that are almost as large as the signal.
    #[must_use]
    pub fn is_vague(&self) -> bool {
        self.largest > 0.0 && self.allowance > VAGUE * self.scale
    }

    /// Whether the written digits explain all differences.
    #[must_use]
    pub fn is_explained(&self) -> bool {
        self.unexplained.is_none()
    }
}

/// Reads a recording: columns of inputs and outputs in any order; `map` assigns signals to columns where the names differ.
/// An input without a column keeps its start value. Without a shape of inputs only the outputs are read.
///
/// # Errors
/// All errors, including a recording without any output column and a sample time that differs from the cycle time.
pub fn read(
    table: &Table<'_>,
    [inputs, outputs]: [&Shape; 2],
    is_alone: bool,
    map: &Map,
    cycle_time_ns: u32,
) -> Result<Recording, Vec<Mistake>> {
    let names = |shape: &Shape| shape.signals.iter().map(|signal| signal.name.clone()).collect::<Vec<_>>();
    let first_output = if is_alone { inputs.signals.len() } else { 0 };
    let both =
        Shape { real: inputs.real, signals: [&inputs.signals[..first_output], outputs.signals.as_slice()].concat() };
    let all = names(inputs);
    let other: Vec<&str> = all.iter().filter(|_| !is_alone).map(String::as_str).collect();
    let found = signals::of_columns(table, &both, &other, map)?;
    let mut columns: Vec<usize> = found.iter().flatten().copied().collect();
    columns.sort_unstable();
    let (given, of_outputs): (Vec<usize>, Vec<usize>) = columns.iter().partition(|signal| **signal < first_output);
    if of_outputs.is_empty() {
        let found = "no column of an output, so that there is nothing to compare";
        let columns = table.columns.first().map_or("NAME", Column::called);
        let mistake = Mistake::new([1, 1], found, names(outputs).join(", "));
        return Err(vec![mistake.instead(format!("--map \"{columns}=SIGNAL\" for the columns of other names"))]);
    }
    let read = series::read(table, &found, &both, Some(cycle_time_ns))?;
    let left_out = table.columns.iter().zip(&found).filter(|(_, signal)| signal.is_none());
    let name = |(signal, count): &(usize, usize)| (both.signals[*signal].name.clone(), *count);
    Ok(Recording {
        inputs: read.samples.only(&(0..first_output).collect::<Vec<_>>()),
        given,
        outputs: read.samples.only(&of_outputs),
        left_out: left_out.map(|(column, _)| column.called().to_owned()).collect(),
        skipped: read.skipped.iter().map(name).collect(),
        lines: read.lines,
        input_precision: read.precision[..first_output].to_vec(),
        output_precision: of_outputs.iter().map(|signal| read.precision[*signal]).collect(),
        recorded: of_outputs.iter().map(|signal| signal - first_output).collect(),
    })
}

/// The inputs of a stimulus, and the positions of those with a column. Columns of `outputs` are left out if the map or an
/// export names them.
///
/// # Errors
/// All errors: unknown and repeated columns, another sample time than the cycle time, bad cells.
pub fn stimulus(
    table: &Table<'_>,
    [inputs, outputs]: [&Shape; 2],
    map: &Map,
    cycle_time_ns: u32,
) -> Result<(Samples, Vec<usize>), Vec<Mistake>> {
    let other: Vec<&str> = outputs.signals.iter().map(|signal| signal.name.as_str()).collect();
    let is_mapped = |name: &&str| map.iter().any(|(_, signal)| signal == name);
    let other: Vec<&str> = other.into_iter().filter(is_mapped).collect();
    let found = signals::of_columns(table, inputs, &other, map)?;
    let mut given: Vec<usize> = found.iter().flatten().copied().collect();
    given.sort_unstable();
    series::read(table, &found, inputs, Some(cycle_time_ns)).map(|read| (read.samples, given))
}

impl Recording {
    /// The recording with the first samples only.
    #[must_use]
    pub fn first(&self, count: usize) -> Self {
        self.with_samples(self.inputs.first(count), self.outputs.first(count))
    }

    /// The recording with other samples.
    pub(crate) fn with_samples(&self, inputs: Samples, outputs: Samples) -> Self {
        Self { inputs, outputs, ..self.clone() }
    }

    /// The recording with the inputs of a stimulus, if it contains no inputs: then all their bits are known.
    #[must_use]
    pub fn with_inputs(self, inputs: &Samples) -> Self {
        if self.inputs.shape == inputs.shape {
            return self;
        }
        let signals = inputs.shape.signals.len();
        Self {
            inputs: inputs.clone(),
            given: (0..signals).collect(),
            input_precision: vec![Precision::default(); signals],
            ..self
        }
    }

    /// The recording with reduced precision: values were rounded once more because all were multiplied by a factor, or they
    /// are not the bits of the block. Then not every bit must agree.
    pub(crate) fn inexact(mut self, factor: Option<f64>) -> Self {
        let (real, factor) = (self.outputs.shape.real, factor.unwrap_or(1.0));
        for given in &self.given {
            self.input_precision[*given] = self.input_precision[*given].inexact(real, factor);
        }
        for (precision, signal) in self.output_precision.iter_mut().zip(&self.outputs.shape.signals) {
            if signal.ty == Type::Real {
                *precision = precision.inexact(real, factor);
            }
        }
        self
    }

    /// The recording with at most this number of written digits.
    pub(crate) fn up_to(mut self, digits: usize) -> Self {
        for precision in self.input_precision.iter_mut().chain(&mut self.output_precision) {
            precision.digits = precision.digits.min(digits);
        }
        self
    }

    /// Inputs with the same written text: each real is moved by half a unit of its last digit, up or down. `None` if the
    /// inputs are exact, or if all outputs are, so that nothing explains an error.
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

    /// The largest magnitude of a recorded output.
    fn largest(&self, signal: usize) -> f64 {
        pairs(&self.outputs, &self.outputs, signal)
            .filter_map(|(_, [value, _])| number(value))
            .fold(0.0, |largest, value| if value.abs() > largest { value.abs() } else { largest })
    }

    /// The differences between the recorded outputs and those of an engine; `moved` are the outputs for moved inputs. An
    /// error is explained by half a unit of the last digit, plus at most twice the change by the moved inputs.
    #[must_use]
    pub fn errors(&self, computed: &Samples, moved: Option<&Samples>) -> Vec<Error> {
        let signals = 0..self.recorded.len();
        let change =
            moved.map(|moved| signals.clone().map(|signal| changes(computed, moved, signal)).collect::<Vec<_>>());
        let of = |signal: usize| {
            let allowance = change.as_ref().map_or(0.0, |change| 2.0 * change[signal]);
            let mut error =
                Error { largest: 0.0, sample: 0, unexplained: None, allowance, scale: self.largest(signal) };
            for (sample, [recorded, computed]) in pairs(&self.outputs, computed, signal) {
                let difference = apart(recorded, computed);
                let unit = number(recorded).map_or(0.0, |value| self.output_precision[signal].unit(value));
                let half = 0.5 * unit + allowance;
                error.allowance = if half > error.allowance { half } else { error.allowance };
                // A difference of a real whose bits were recorded has no explanation.
                let is_written_so = unit > 0.0 || matches!(recorded, Literal::I32(_));
                let is_near = difference <= half * (1.0 + 1e-12);
                if recorded != computed && !(is_written_so && is_near) {
                    error.unexplained = Some([error.unexplained.map_or(sample, |[first, _]| first), sample]);
                }
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

/// The values of a signal in the samples of both runs.
fn pairs<'s>(a: &'s Samples, b: &'s Samples, signal: usize) -> impl Iterator<Item = (usize, [Literal; 2])> + 's {
    let (mut of_a, mut of_b) = (Vec::new(), Vec::new());
    (0..a.len().min(b.len())).map(move |sample| {
        a.read(sample, &mut of_a);
        b.read(sample, &mut of_b);
        (sample, [of_a[signal], of_b[signal]])
    })
}

/// The distance of two values; infinite if they differ and are not both numbers.
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
    if let Literal::I32(value) = value { Some(f64::from(value)) } else { arithmetic::wide(value) }
}
