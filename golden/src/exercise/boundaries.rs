//! Events that lead a block to the points where its integers and flags change: the boundaries of process data, and limits.
//! Noise does not reach them; they are found by bisection on the block's own program, one real input at a time.

use crate::csv::{Reals, cell};
use crate::stimulus::Event;
use compiler::interp::Machine;
use compiler::program::{Program, Type};
use portable::{Literal, RealKind};
use reference::signal::sample_limit;

/// Numbers on either side of a change.
const NEIGHBOURS: i64 = 3;

/// Pairs of cycles from `first` on: a reset, and the first cycle after it with one real input near a change. All other
/// reals are 0, feedforward is active, improved position control is off.
pub(super) fn events(block: &Program, real: RealKind, first: u64) -> Vec<Event> {
    let mut probes = Vec::new();
    for (input, variable) in block.inputs.iter().enumerate().filter(|(_, variable)| variable.ty == Type::Real) {
        let mut values: Vec<i64> =
            [1.0, -1.0].iter().flat_map(|sign| changes(block, real, input, sign * largest(real))).collect();
        values.sort_unstable();
        values.dedup();
        let near = values.iter().flat_map(|value| value - NEIGHBOURS..=value + NEIGHBOURS);
        probes.extend(near.map(|value| (variable.path.clone(), number(value, real))));
    }
    let event = |signal: &str, value: Literal, at: u64, length: u64| {
        let mut text = String::new();
        cell(value, Reals::Hexadecimal, &mut text);
        Event::new(signal, &text, at, length, 0)
    };
    let length = 2 * probes.len() as u64;
    let mut events = Vec::new();
    if length > 0 {
        let base = block.inputs.iter().zip(base(block));
        events.extend(base.map(|(variable, value)| event(&variable.path, value, first, length)));
    }
    for (at, (signal, value)) in (first..).step_by(2).zip(probes) {
        events.push(event("reset", Literal::Bool(true), at, 1));
        events.push(event(&signal, value, at + 1, 1));
    }
    events
}

/// The values of the inputs while one of them is searched.
fn base(block: &Program) -> Vec<Literal> {
    let value = |variable: &compiler::program::Variable| match variable.path.as_str() {
        "mode" => Literal::I32(0),
        "feedforward_active" => Literal::Bool(true),
        _ => variable.start,
    };
    block.inputs.iter().map(value).collect()
}

/// The largest magnitude that is tried, well within the range.
fn largest(real: RealKind) -> f64 {
    match real {
        RealKind::F64 => sample_limit::<f64>() / 2.0,
        RealKind::F32 => f64::from(sample_limit::<f32>() / 2.0),
    }
}

/// The numbers, in order, at which an integer or a flag changes to its value at `far`.
fn changes(block: &Program, real: RealKind, input: usize, far: f64) -> Vec<i64> {
    let inputs = base(block);
    let answers = |place: i64| {
        let (mut given, mut answers) = (inputs.clone(), Vec::new());
        given[input] = number(place, real);
        Machine::start(block).step(&given, &mut answers);
        answers
    };
    let far = place(far, real);
    let (at_rest, at_end) = (answers(0), answers(far));
    let is_searched = |output: &usize| {
        matches!(block.outputs[*output].ty, Type::I32 | Type::Bool) && at_rest[*output] != at_end[*output]
    };
    let search = |output: usize| {
        let (mut before, mut after) = (0, far);
        while (after - before).abs() > 1 {
            let middle = before + (after - before) / 2;
            if answers(middle)[output] == at_end[output] { after = middle } else { before = middle }
        }
        after
    };
    (0..block.outputs.len()).filter(is_searched).map(search).collect()
}

/// The index of a number among all numbers of its type: 0 for 0, one more for each larger number.
#[expect(clippy::cast_possible_truncation, reason = "half of the sample limit is a number of both types")]
fn place(x: f64, real: RealKind) -> i64 {
    let of_magnitude = match real {
        RealKind::F64 => x.abs().to_bits().cast_signed(),
        RealKind::F32 => i64::from((x.abs() as f32).to_bits()),
    };
    if x < 0.0 { -of_magnitude } else { of_magnitude }
}

/// The number at an index.
#[expect(clippy::cast_possible_truncation, reason = "places of single precision have 32 bits")]
fn number(place: i64, real: RealKind) -> Literal {
    let sign = if place < 0 { -1.0 } else { 1.0 };
    match real {
        RealKind::F64 => Literal::F64(f64::from_bits(place.unsigned_abs()) * sign),
        RealKind::F32 => Literal::F32(f32::from_bits(place.unsigned_abs() as u32) * sign as f32),
    }
}
