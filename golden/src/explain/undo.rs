//! Undoes a mistake: the recording without it, and the block for comparison.

use super::Case;
use super::change::{At, Change, Side};
use crate::case::named_block;
use crate::recording::Recording;
use crate::samples::{Samples, Shape};
use crate::subject::{literal, number};
use generator::blocks::{Block, Designed};
use portable::{Literal, RealKind};

/// The recording without a mistake.
pub(super) struct Undone {
    pub recording: Recording,
    /// the block, if it is another one
    pub block: Option<(Designed, Block)>,
}

/// `None` if the recording cannot have this mistake.
pub(super) fn undo(case: &Case<'_>, change: &Change) -> Option<Undone> {
    let of = |recording: Recording| Some(Undone { recording, block: None });
    let recording = &case.recording;
    match change {
        Change::Sign(columns) => of(scaled(recording, columns, -1.0)),
        Change::Factor(columns, factor) => of(scaled(recording, columns, 1.0 / factor).inexact(Some(*factor))),
        Change::Swapped(one, other) => of(swapped(recording, *one, *other)),
        Change::OutputsLate(cycles) => of(outputs_late(recording, *cycles)?),
        Change::InputLate(at, cycles) => of(input_late(recording, *at, *cycles)?),
        Change::Repeated(times, first) => of(every(recording, *times, *first)?),
        Change::Constant(at, value) => of(each(recording, |inputs, _| inputs[*at] = *value)),
        Change::Same(at, other) => of(each(recording, |inputs, _| inputs[*at] = inputs[*other])),
        Change::CycleTime(time) => {
            let is_possible = |f0: f64| f0 * f64::from(*time) / 1e9 <= 0.45;
            let axis = &case.designed.axis;
            let is_possible = axis.ipc.filter_f0s().all(is_possible);
            let axis = generator::axis::Axis { cycle_time_ns: *time, ..axis.clone() };
            is_possible.then(|| other_block(case, Designed::from(axis)))?
        }
        Change::Real(real) => {
            let axis = generator::axis::Axis { real: *real, ..case.designed.axis.clone() };
            other_block(case, Designed::from(axis))
        }
        Change::Axis(at) => other_block(case, case.others[*at].clone()),
        Change::StageOff(stage) => {
            let mut axis = case.designed.axis.clone();
            axis.ipc.stage[*stage] = None;
            other_block(case, Designed::from(axis))
        }
    }
}

/// A recording with changed values in each sample: all inputs, and the recorded outputs.
fn each(recording: &Recording, mut change: impl FnMut(&mut [Literal], &mut [Literal])) -> Recording {
    let mut changed = recording.first(0);
    let (mut inputs, mut outputs) = (Vec::new(), Vec::new());
    for sample in 0..recording.inputs.len().min(recording.outputs.len()) {
        recording.inputs.read(sample, &mut inputs);
        recording.outputs.read(sample, &mut outputs);
        change(&mut inputs, &mut outputs);
        changed.inputs.push(&inputs);
        changed.outputs.push(&outputs);
    }
    changed
}

fn scaled(recording: &Recording, columns: &[At], factor: f64) -> Recording {
    each(recording, |inputs, outputs| {
        for (side, at) in columns {
            let value = match side {
                Side::Input => &mut inputs[*at],
                Side::Output => &mut outputs[*at],
            };
            *value = times(*value, factor);
        }
    })
}

fn times(value: Literal, factor: f64) -> Literal {
    match value {
        Literal::F64(value) => Literal::F64(value * factor),
        #[expect(clippy::cast_possible_truncation, reason = "single precision is what the block reads")]
        Literal::F32(value) => Literal::F32((f64::from(value) * factor) as f32),
        other => other,
    }
}

fn swapped(recording: &Recording, one: At, other: At) -> Recording {
    let mut swapped = each(recording, |inputs, outputs| swap(inputs, outputs, one, other));
    let Recording { input_precision, output_precision, .. } = &mut swapped;
    swap(input_precision, output_precision, one, other);
    swapped
}

/// Swaps the values of two columns.
fn swap<T>(inputs: &mut [T], outputs: &mut [T], one: At, other: At) {
    match (one, other) {
        ((Side::Input, one), (Side::Input, other)) => inputs.swap(one, other),
        ((Side::Output, one), (Side::Output, other)) => outputs.swap(one, other),
        ((Side::Input, input), (Side::Output, output)) | ((Side::Output, output), (Side::Input, input)) => {
            std::mem::swap(&mut inputs[input], &mut outputs[output]);
        }
    }
}

/// The outputs with the inputs of other samples; samples without a partner are left out.
fn outputs_late(recording: &Recording, cycles: i32) -> Option<Recording> {
    let count = usize::try_from(cycles.unsigned_abs()).ok()?;
    let rest = recording.outputs.len().checked_sub(count).filter(|rest| *rest > 0)?;
    let Recording { inputs, outputs, .. } = recording;
    let (inputs, outputs) = match cycles > 0 {
        true => (inputs.first(rest), outputs.after(count)),
        false => (inputs.after(count), outputs.first(rest)),
    };
    Some(recording.with_samples(inputs, outputs))
}

/// One input with the values of other samples; before the first sample its first value is used.
fn input_late(recording: &Recording, at: usize, cycles: i32) -> Option<Recording> {
    let count = usize::try_from(cycles.unsigned_abs()).ok()?;
    let rest = recording.outputs.len().checked_sub(count).filter(|rest| *rest > 0)?;
    let (mut values, mut sample) = (Vec::new(), 0);
    let mut changed = each(recording, |inputs, _| {
        let from = if cycles > 0 { sample + count } else { sample.saturating_sub(count) };
        if from < recording.inputs.len() {
            recording.inputs.read(from, &mut values);
            inputs[at] = values[at];
        }
        sample += 1;
    });
    if cycles > 0 {
        changed.inputs = changed.inputs.first(rest);
        changed.outputs = changed.outputs.first(rest);
    }
    Some(changed)
}

/// One sample of each run of repeated ones.
fn every(recording: &Recording, times: usize, first: usize) -> Option<Recording> {
    let is_new = |sample: usize| sample == 0 || sample % times == first % times;
    let samples = recording.outputs.len();
    let is_same =
        |sample: usize| [&recording.inputs, &recording.outputs].iter().all(|run| !run.differs(sample - 1, sample));
    if (1..samples).any(|sample| !is_new(sample) && !is_same(sample)) {
        return None;
    }
    let chosen: Vec<usize> = (0..samples).filter(|sample| is_new(*sample)).collect();
    Some(recording.with_samples(recording.inputs.samples(&chosen), recording.outputs.samples(&chosen)))
}

/// The recording as that of this block of another axis.
fn other_block(case: &Case<'_>, designed: Designed) -> Option<Undone> {
    let block = named_block(&designed, case.block.program.block).ok()?;
    let shape = |variables| Shape::of(variables, block.program.real);
    let (inputs, outputs) = (shape(&block.program.inputs), shape(&block.program.outputs));
    let old = &case.recording;
    let places = |from: &Shape, to: &Shape, of: &[usize]| -> Option<Vec<usize>> {
        of.iter().map(|at| to.place(&from.signals[*at].name)).collect()
    };
    let given = places(&old.inputs.shape, &inputs, &old.given)?;
    let all: Vec<usize> = (0..old.outputs.shape.signals.len()).collect();
    let recorded = places(&old.outputs.shape, &outputs, &all)?;
    let mut recording = old.clone();
    recording.inputs = in_real(&old.inputs.only(&old.given), designed.axis.real).among(&given, &inputs);
    recording.input_precision = vec![crate::written::Precision::default(); inputs.signals.len()];
    for (from, to) in old.given.iter().zip(&given) {
        recording.input_precision[*to] = old.input_precision[*from];
    }
    recording.outputs = in_real(&old.outputs, designed.axis.real);
    (recording.given, recording.recorded) = (given, recorded);
    // A value that was read as single precision has lost the digits of a double.
    let is_longer = old.inputs.shape.real == RealKind::F32 && designed.axis.real == RealKind::F64;
    let recording = if is_longer { recording.inexact(None) } else { recording };
    Some(Undone { recording, block: Some((designed, block)) })
}

/// The values in another real type.
fn in_real(samples: &Samples, real: RealKind) -> Samples {
    let shape = Shape { real, signals: samples.shape.signals.clone() };
    let mut converted = Samples::with_capacity(shape.clone(), samples.len());
    let mut values = Vec::new();
    for sample in 0..samples.len() {
        samples.read(sample, &mut values);
        for (value, signal) in values.iter_mut().zip(&shape.signals) {
            *value = literal(number(*value), signal.ty, real);
        }
        converted.push(&values);
    }
    converted
}
