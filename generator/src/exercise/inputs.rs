//! The inputs of a block in its exercise. The kind of run decides when they change.

use super::noise::Noise;
use compiler::legalise::{AxisProgram, RealInput};
use compiler::program::{Program, Type, Variable};
use compiler::{leaf, leaves};
use portable::{Block, Literal, Real};
use reference::check_word::last_piece;
use reference::signal::sample_limit;
use std::ops::Range;

/// The inputs of a block in its exercise. Their positions are those among all inputs that the block can have.
#[derive(Clone, Debug)]
pub(crate) struct Exercise {
    /// the inputs with which the block does everything it can; for a counter, its increment per sample
    pub(crate) usual: Vec<Literal>,
    /// the real inputs that the axis reads: they get noise
    pub(crate) reals: Vec<RealInput>,
    /// the other inputs that it reads, each with its alternative values
    pub(crate) switches: Vec<(usize, Vec<Literal>)>,
    /// the factors of the noise, powers of two: without limiting, full, and 0 at rest
    pub(crate) scales: [Literal; 3],
    /// the factor of noise for a fraction from 0 to 1
    pub(crate) part: Literal,
    /// the drill, in samples from its beginning
    pub(crate) drill: Vec<Turn>,
    /// the inputs that are needed if calls are counted
    pub(crate) calls: Option<Calls>,
    /// the input that turns the block off, and its value for off
    pub(super) off: Option<(usize, Literal)>,
    pub(super) not_a_number: Literal,
    /// numbers that are out of range, or huge
    pub(crate) beyond: Literal,
    pub(super) huge: [Literal; 2],
    /// number of cycles until the parameter set is in use; 0 for a block without
    pub(super) wait: usize,
    /// number of cycles until the block acts in full
    pub(super) start: usize,
    /// the compared outputs and parts of the state
    pub(super) outputs: Vec<usize>,
    pub(super) state: Vec<usize>,
}

/// Some samples in which an input differs from its usual value.
#[derive(Clone, Debug)]
pub(crate) struct Turn {
    pub(crate) samples: Range<usize>,
    pub(crate) input: usize,
    pub(crate) value: Literal,
    /// whether the block is turned off, by any input
    pub(crate) is_off: bool,
}

/// A step of a drill, for states that noise alone would not reach: an input, its value, and the samples with this value,
/// counted from the beginning of the drill.
#[derive(Clone, Debug)]
pub struct Drill {
    pub(crate) input: &'static str,
    /// a real in double precision
    pub(crate) value: Literal,
    pub(crate) samples: Range<usize>,
}

/// The exercise as specified by the block's folder.
pub(crate) struct Wanted {
    /// the ranges of the noise on its real inputs, each above 0: without and with limiting
    pub(crate) ranges: [f64; 2],
    pub(crate) start: usize,
    pub(crate) drill: Vec<Drill>,
    pub(crate) cycle_time_ns: u32,
}

/// The inputs that are needed if calls are counted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Calls {
    pub(crate) counter: usize,
    /// none in a block that its button starts again
    pub(super) reset: Option<usize>,
}

impl Exercise {
    /// The inputs with which a block does everything it can.
    pub(crate) fn usual<R: Real, B: Block<R>>(coeffs: &B::Coeffs) -> Vec<Literal> {
        let mut inputs = B::inputs(coeffs);
        B::exercise(&mut inputs, coeffs);
        leaves(&inputs)
    }

    /// The exercise of a block from its usual inputs; `state_paths` are the paths of all leaves of the reference's state.
    pub(crate) fn of<R: Real>(
        mut usual: Vec<Literal>,
        (program, for_axis): (&Program, &AxisProgram),
        state_paths: &[String],
        wanted: &Wanted,
    ) -> Self {
        let (reals, signals) = (for_axis.reals(), for_axis.signals());
        let position = |path: &str| program.inputs.iter().position(|input| input.path == path);
        let signal = |path: &str| position(path).filter(|input| signals.contains(input));
        let counter = signal("cycle_counter");
        let calls = counter.map(|counter| Calls { counter, reset: position("reset") });
        // If calls are counted, TwinCAT reads the task's values where these are 0.
        if let (Some(counter), Some(cycle)) = (counter, position("task_cycle_ns")) {
            (usual[counter], usual[cycle]) = (Literal::U32(1), Literal::U32(wanted.cycle_time_ns));
        }
        let is_switch = |input: &usize| reals.iter().all(|real| real.position != *input);
        let turn = |of: &Drill| Some(Turn::new(of.samples.clone(), signal(of.input)?, in_real::<R>(of.value)));
        let [quiet, loud] = wanted.ranges;
        let huge = sample_limit::<R>() * R::lit(0.125);
        let of_sets = cycles_of_set::<R>(&for_axis.program);
        Self {
            drill: wanted.drill.iter().filter_map(turn).collect(),
            switches: signals.iter().copied().filter(is_switch).map(|input| (input, others(usual[input]))).collect(),
            scales: [Noise::scale::<R>(quiet), Noise::scale::<R>(loud), leaf(R::ZERO)],
            part: Noise::part::<R>(),
            calls,
            off: program.switch.as_ref().map(|switch| (switch.input, switch.off.value())),
            not_a_number: leaf(R::lit(f64::NAN)),
            beyond: leaf(sample_limit::<R>() + sample_limit::<R>()),
            huge: [leaf(huge), leaf(-huge)],
            wait: if program.typed { wanted.start } else { of_sets },
            start: wanted.start + of_sets,
            outputs: for_axis.outputs.clone(),
            state: kept(&for_axis.program, state_paths),
            usual,
            reals,
        }
    }

    /// The input that counts the calls.
    pub(crate) fn counter(&self) -> Option<usize> {
        self.calls.map(|calls| calls.counter)
    }

    /// The usual inputs of a sample; calls are counted from 1.
    pub(super) fn usual_at(&self, sample: usize) -> Vec<Literal> {
        let mut inputs = self.usual.clone();
        if let Some(counter) = self.counter() {
            inputs[counter] = Literal::U32(u32::try_from(sample).unwrap_or(u32::MAX).wrapping_add(1));
        }
        inputs
    }
}

impl Turn {
    pub(super) fn new(samples: Range<usize>, input: usize, value: Literal) -> Self {
        Self { samples, input, value, is_off: false }
    }

    /// The event, delayed by N samples.
    pub(super) fn later(&self, by: usize) -> Self {
        Self { samples: self.samples.start + by..self.samples.end + by, ..self.clone() }
    }
}

/// A real of a drill in the real type of the block.
fn in_real<R: Real>(value: Literal) -> Literal {
    match value {
        Literal::F64(value) => leaf(R::lit(value)),
        other => other,
    }
}

/// The number of cycles until the block uses its parameter set; 0 for a block without sets.
fn cycles_of_set<R: Real>(program: &Program) -> usize {
    let is_number = |input: &&Variable| input.ty == Type::Real && program.in_set(input).is_some();
    let numbers = program.inputs.iter().filter(is_number).count();
    // Each number is checked in pieces, one in a cycle, before and after all are copied.
    let pieces = last_piece::<R>() as usize + 1;
    if numbers > 0 { 2 * (numbers * pieces + 2) } else { 0 }
}

/// The positions of the parts of a program's state among all leaves of the reference's.
fn kept(program: &Program, state_paths: &[String]) -> Vec<usize> {
    let place = |part: &Variable| state_paths.iter().position(|path| *path == part.path);
    let places: Option<Vec<usize>> = program.state.iter().map(place).collect();
    let places = places.expect("exercise: the program's state is part of the reference's");
    assert!(places.is_sorted(), "exercise: the program's state is in another order than the reference's");
    places
}

/// Other values of a switch; for an integer its neighbours and two distant ones.
fn others(value: Literal) -> Vec<Literal> {
    match value {
        Literal::Bool(value) => vec![Literal::Bool(!value)],
        Literal::I32(value) => [1, -1, 200, -200].map(|more| Literal::I32(value.wrapping_add(more))).into(),
        Literal::U32(value) => vec![Literal::U32(value.wrapping_add(1))],
        // What somebody types changes in the drill only.
        Literal::F64(_) | Literal::F32(_) => Vec::new(),
        other => panic!("exercise: {other:?} is not a switch"),
    }
}
