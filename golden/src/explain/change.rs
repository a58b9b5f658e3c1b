//! The table of mistakes: those that a recording can have, the most likely ones first, and their descriptions.

use super::Case;
use crate::samples::{Samples, Shape};
use crate::subject::number;
use compiler::program::Type;
use portable::{Literal, RealKind};

/// A side of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Input,
    Output,
}

/// A column of a recording: an input by its position among all inputs, an output by its position among the recorded ones.
pub type At = (Side, usize);

/// A mistake in a recording, or in the set with which it is compared.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// these columns have the other sign
    Sign(Vec<At>),
    /// these columns are too large by a factor
    Factor(Vec<At>, f64),
    /// two columns are swapped
    Swapped(At, At),
    /// all outputs were recorded this number of cycles late, or early if it is negative
    OutputsLate(i32),
    /// one input was recorded this number of cycles later than the others, or earlier if it is negative
    InputLate(usize, i32),
    /// every cycle was recorded this number of times; and the number of samples after which the first one ends
    Repeated(usize, usize),
    /// an input without a column had this value
    Constant(usize, Literal),
    /// an input without a column was equal to another one
    Same(usize, usize),
    /// the block was generated for this cycle time [ns]
    CycleTime(u32),
    /// the block computes in this real type
    Real(RealKind),
    /// the block is that of another axis, by its position among the other axes
    Axis(usize),
    /// a stage of the block was not active
    StageOff(usize),
}

/// Usual wrong factors: an SI prefix, minutes for seconds, degrees for turns.
const FACTORS: [f64; 8] = [1e3, 1e-3, 60.0, 1.0 / 60.0, 1e6, 1e-6, 360.0, 1.0 / 360.0];
const CYCLES_LATE: [i32; 20] = [1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 7, -7, 8, -8, 9, -9, 10, -10];
const CYCLE_TIMES: [u32; 12] = [
    62_500, 125_000, 200_000, 250_000, 400_000, 500_000, 1_000_000, 2_000_000, 4_000_000, 5_000_000, 8_000_000,
    10_000_000,
];

/// All mistakes that the recording can have.
pub(super) fn all(case: &Case<'_>) -> Vec<Change> {
    let recording = &case.recording;
    let [inputs, outputs] = [&recording.inputs.shape, &recording.outputs.shape];
    let columns = |side: Side, shape: &Shape, of: &[usize]| -> Vec<(At, Type)> {
        of.iter().map(|at| ((side, *at), shape.signals[*at].ty)).collect()
    };
    let given = columns(Side::Input, inputs, &recording.given);
    let recorded = columns(Side::Output, outputs, &(0..outputs.signals.len()).collect::<Vec<_>>());
    let reals = |columns: &[(At, Type)]| -> Vec<At> {
        columns.iter().filter(|(_, ty)| *ty == Type::Real).map(|(at, _)| *at).collect()
    };
    let mut groups: Vec<Vec<At>> = Vec::new();
    for reals in [reals(&given), reals(&recorded)] {
        groups.extend(reals.iter().map(|at| vec![*at]));
        groups.extend((reals.len() > 1).then_some(reals));
    }
    let mut changes: Vec<Change> = groups.iter().cloned().map(Change::Sign).collect();
    let factors = |group: &Vec<At>| FACTORS.map(|factor| Change::Factor(group.clone(), factor));
    changes.extend(groups.iter().flat_map(factors));
    let all = [given, recorded].concat();
    for (at, (one, ty)) in all.iter().enumerate() {
        changes.extend(
            all[at + 1..].iter().filter(|(_, other)| other == ty).map(|(other, _)| Change::Swapped(*one, *other)),
        );
    }
    changes.extend(CYCLES_LATE.map(Change::OutputsLate));
    let moving = reals(&all).into_iter().filter(|(side, _)| *side == Side::Input);
    changes.extend(moving.flat_map(|(_, at)| CYCLES_LATE.map(|cycles| Change::InputLate(at, cycles))));
    changes.extend((2..=10).flat_map(|times| (1..=times).map(move |first| Change::Repeated(times, first))));
    changes.extend(without_column(&recording.inputs, &recording.given));
    changes.extend(of_set(case));
    changes
}

/// The possible values of inputs without a column.
fn without_column(inputs: &Samples, given: &[usize]) -> Vec<Change> {
    let mut changes = Vec::new();
    for (at, signal) in inputs.shape.signals.iter().enumerate().filter(|(at, _)| !given.contains(at)) {
        match signal.ty {
            Type::Bool => changes.extend([false, true].map(|value| Change::Constant(at, Literal::Bool(value)))),
            Type::I32 => changes.extend([0, 1, 2].map(|value| Change::Constant(at, Literal::I32(value)))),
            Type::U32 => {}
            Type::Real => {
                let reals = given.iter().filter(|given| inputs.shape.signals[**given].ty == Type::Real);
                changes.extend(reals.map(|given| Change::Same(at, *given)));
            }
        }
    }
    changes
}

/// The possible mistakes in the set.
fn of_set(case: &Case<'_>) -> Vec<Change> {
    let axis = &case.designed.axis;
    let other_real = match axis.real {
        RealKind::F64 => RealKind::F32,
        RealKind::F32 => RealKind::F64,
    };
    let stages = axis.ipc.stage.iter().enumerate().filter(|(_, stage)| stage.is_some()).map(|(at, _)| at);
    let mut changes = vec![Change::Real(other_real)];
    changes.extend(CYCLE_TIMES.into_iter().filter(|time| *time != axis.cycle_time_ns).map(Change::CycleTime));
    changes.extend((0..case.others.len()).map(Change::Axis));
    changes.extend(stages.map(Change::StageOff));
    changes
}

impl Change {
    /// A description of the mistake, in a sentence.
    pub(super) fn said(&self, case: &Case<'_>) -> String {
        let recording = &case.recording;
        let name = |(side, at): &At| match side {
            Side::Input => recording.inputs.shape.signals[*at].name.as_str(),
            Side::Output => recording.outputs.shape.signals[*at].name.as_str(),
        };
        let names = |columns: &[At]| columns.iter().map(name).collect::<Vec<_>>().join(", ");
        let input = |at: usize| name(&(Side::Input, at));
        match self {
            Self::Sign(columns) => format!("the recording has {} with the other sign", names(columns)),
            Self::Factor(columns, factor) if *factor < 1.0 => {
                format!("the recording has {} divided by {}", names(columns), libm::round(1.0 / factor))
            }
            Self::Factor(columns, factor) => format!("the recording has {} times {factor}", names(columns)),
            Self::Swapped(one, other) => format!("the columns {} and {} are swapped", name(one), name(other)),
            Self::OutputsLate(cycles) => format!("the outputs were recorded {} against the inputs", late(*cycles)),
            Self::InputLate(at, cycles) => {
                format!("{} was recorded {} against the other columns", input(*at), late(*cycles))
            }
            Self::Repeated(times, _) => {
                format!("every cycle was recorded {times} times: another sampling than the block's cycle")
            }
            Self::Constant(at, value) => format!("{}, which has no column, was {}", input(*at), number(*value)),
            Self::Same(at, other) => format!("{}, which has no column, was the same as {}", input(*at), input(*other)),
            Self::CycleTime(time) => {
                let [block, set] = [*time, case.designed.axis.cycle_time_ns].map(|time| f64::from(time) / 1e6);
                format!("the block was generated for a cycle time of {block} ms, the set says {set} ms")
            }
            Self::Real(real) => {
                let [block, set] = computed_in(*real);
                format!("the block computes in {block}, that of the set in {set}")
            }
            Self::Axis(at) => format!("it is the block of the axis {}", case.others[*at].axis.name),
            Self::StageOff(stage) => format!("the block has other parameters: stage[{stage}] is not active in it"),
        }
    }
}

/// `1 cycle late`, `2 cycles early`.
fn late(cycles: i32) -> String {
    let count = cycles.unsigned_abs();
    let plural = if count == 1 { "cycle" } else { "cycles" };
    format!("{count} {plural} {}", if cycles > 0 { "late" } else { "early" })
}

/// The real type of the block, and the other one, which is that of the set.
fn computed_in(real: RealKind) -> [&'static str; 2] {
    match real {
        RealKind::F32 => ["REAL (real = \"f32\")", "LREAL"],
        RealKind::F64 => ["LREAL (real = \"f64\")", "REAL"],
    }
}
