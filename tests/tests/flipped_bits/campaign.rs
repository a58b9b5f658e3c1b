//! One bit of a block's state flips in mid-run. What becomes of it: reported, harmless, or silent.

use axgen_tests::random::overwritten::flipped;
use compiler::interp::Machine;
use compiler::program::{Program, Type};
use generator::blocks::{Block, Designed};
use golden::subject::number;
use portable::{Literal, RealKind};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Cycles of a run.
pub const RUN: usize = 4_000;
/// The cycle before which a bit flips: everything is faded in.
pub const FLIP: usize = 400;
/// The cycle from which on nothing may be left of it.
const SETTLED: usize = 3_900;
/// What may be left then, as a part of the largest magnitude of an output.
const LEFT: f64 = 1e-4;
/// Samples that a delay holds, at most.
const DELAYS: usize = 7;
/// Outputs into which improved position control goes: while a section forgets what was overwritten, they deviate by twice its limit
/// at most.
const WITH_ADDITION: [&str; 5] =
    ["v_add", "v_add_calculated", "v_command", "manipulated_variable", "additive_velocity"];

/// What becomes of flips.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// a fault within the stated number of cycles, or another report
    pub reported: usize,
    /// outputs as before within the stated bounds
    pub harmless: usize,
    /// neither
    pub silent: usize,
    /// the most cycles from the flip of a number in use to its report
    pub latest: usize,
    /// silent flips, by their place
    pub places: BTreeMap<String, usize>,
}

impl Table {
    /// Both.
    pub fn and(mut self, other: Self) -> Self {
        self.reported += other.reported;
        self.harmless += other.harmless;
        self.silent += other.silent;
        self.latest = self.latest.max(other.latest);
        for (place, count) in other.places {
            *self.places.entry(place).or_default() += count;
        }
        self
    }
}

/// Every `every`th bit of a state, from the first on, and each sign: the place of its value, and the bit.
pub fn flips(state: &[Literal], every: usize) -> Vec<(usize, usize)> {
    let bits = |value: &Literal| match value {
        Literal::Bool(_) => 1,
        Literal::F64(_) => 64,
        _ => 32,
    };
    let all = state.iter().enumerate().flat_map(|(at, value)| (0..bits(value)).map(move |bit| (at, bit)));
    let is_sign = |(at, bit): (usize, usize)| bit > 0 && bit + 1 == bits(&state[at]);
    all.enumerate().filter(|(index, flip)| index % every == 0 || is_sign(*flip)).map(|(_, flip)| flip).collect()
}

/// A block with its inputs, and what it does undisturbed.
pub struct Bench<'b> {
    program: &'b Program,
    limit: f64,
    inputs: Vec<Vec<Literal>>,
    states: Vec<Literal>,
    outputs: Vec<Vec<Literal>>,
    largest: Vec<f64>,
}

impl<'b> Bench<'b> {
    pub fn of(designed: &Designed, block: &'b Block) -> Self {
        let program = &block.program;
        let inputs: Vec<_> = (0..RUN).map(|cycle| inputs(program, cycle, designed)).collect();
        let mut machine = Machine::start(program);
        let (mut states, mut outputs, mut answers) = (Vec::new(), Vec::new(), Vec::new());
        for (cycle, given) in inputs.iter().enumerate() {
            if cycle == FLIP {
                states = machine.state().to_vec();
            }
            machine.step(given, &mut answers);
            outputs.push(answers.clone());
        }
        let largest = |output: usize| outputs.iter().map(|cycle| number(cycle[output]).abs()).fold(0.0, f64::max);
        let largest = (0..program.outputs.len()).map(largest).collect();
        Self { program, limit: designed.ipc.limit, inputs, states, outputs, largest }
    }

    /// Every `every`th bit of the state, from the first on.
    pub fn flips(&self, every: usize) -> Vec<(usize, usize)> {
        flips(&self.states, every)
    }

    /// Flips one bit.
    pub fn run(&self, (at, bit): (usize, usize)) -> Table {
        let mut state = self.states.clone();
        state[at] = flipped(state[at], bit);
        let mut machine = Machine::start(self.program);
        machine.set_state(&state);
        let mut reported = None;
        let mut wrong = None;
        let mut answers = Vec::new();
        for cycle in FLIP..RUN {
            machine.step(&self.inputs[cycle], &mut answers);
            let expected = &self.outputs[cycle];
            if reported.is_none() && self.reports(&answers, expected) {
                reported = Some(cycle - FLIP);
            }
            for (output, variable) in self.program.outputs.iter().enumerate() {
                let (found, undisturbed) = (number(answers[output]), number(expected[output]));
                let left = (found - undisturbed).abs();
                let is_wrong = !found.is_finite()
                    || ["v_add", "v_add_calculated"].contains(&&*variable.path) && found.abs() > self.limit
                    || cycle >= SETTLED && left > LEFT * self.largest[output].max(1e-9) && !is_count(&variable.path)
                    || reported.is_none() && variable.ty == Type::Real && left > self.allowed(at, output, cycle);
                if is_wrong && wrong.is_none() {
                    wrong = Some((cycle - FLIP, variable.path.clone(), found, undisturbed));
                }
            }
        }
        let mut table = Table::default();
        match (wrong, reported) {
            (Some((cycle, path, found, undisturbed)), _) => {
                table.silent = 1;
                let place = &self.program.state[at].path;
                table.places.insert(
                    format!(
                        "{place}: {path} {found:e} for {undisturbed:e} after {cycle}, bit {bit}, reported {reported:?}"
                    ),
                    1,
                );
            }
            (None, Some(cycles)) => {
                table.reported = 1;
                table.latest = if self.is_compared(at) { cycles } else { 0 };
            }
            (None, None) if self.is_compared(at) => table.places.extend([(self.program.state[at].path.clone(), 1)]),
            (None, None) => table.harmless = 1,
        }
        table
    }

    /// The bits of the position that a drive holds while `x_command` is not a number, and of its copy.
    pub fn flips_of_the_held_position(&self) -> Vec<(usize, usize)> {
        let is_held = |at: usize| self.program.state[at].path.contains("x_held");
        self.flips(1).into_iter().filter(|(at, _)| is_held(*at)).collect()
    }

    /// A cycle without `x_command`, with a flipped bit or none: `x_drive` and `error_id`.
    pub fn hold(&self, flip: Option<(usize, usize)>) -> (f64, f64) {
        let mut state = self.states.clone();
        if let Some((at, bit)) = flip {
            state[at] = flipped(state[at], bit);
        }
        let mut inputs = self.inputs[FLIP].clone();
        let x_command = self.program.inputs.iter().position(|input| input.path == "x_command").expect("it holds one");
        inputs[x_command] = match self.program.real {
            RealKind::F64 => Literal::F64(f64::NAN),
            RealKind::F32 => Literal::F32(f32::NAN),
        };
        let mut machine = Machine::start(self.program);
        machine.set_state(&state);
        let mut answers = Vec::new();
        machine.step(&inputs, &mut answers);
        let output = |path: &str| {
            let place = self.program.outputs.iter().position(|output| output.path == path);
            number(answers[place.expect("the block has it")])
        };
        (output("x_drive"), output("error_id"))
    }

    /// Whether a value is a number in use, or its copy.
    fn is_compared(&self, at: usize) -> bool {
        let path = &self.program.state[at].path;
        path.starts_with("now.") || path.starts_with("copy.")
    }

    /// The cycles within which a number in use that differs from its copy is reported: 4 N + 3 with N numbers.
    pub fn stated(&self) -> usize {
        let numbers = self.program.state.iter().filter(|variable| variable.path.starts_with("now.")).count();
        4 * numbers + 3
    }

    /// Whether an output says that something is wrong which is not wrong without the flip.
    fn reports(&self, answers: &[Literal], expected: &[Literal]) -> bool {
        let mut signals = self.program.outputs.iter().zip(answers.iter().zip(expected));
        signals.any(|(variable, (found, expected))| {
            ["fault", "error_id", "tripped", "active_set"].contains(&variable.path.as_str()) && found != expected
        })
    }

    /// Whether a set is in use after this cycle, with a bit that has flipped before another one.
    pub fn takes_a_set(&self, (at, bit): (usize, usize), before: usize, end: usize) -> bool {
        let mut machine = Machine::start(self.program);
        let mut answers = Vec::new();
        for (cycle, given) in self.inputs[..=end].iter().enumerate() {
            if cycle == before {
                let mut state = machine.state().to_vec();
                state[at] = flipped(state[at], bit);
                machine.set_state(&state);
            }
            machine.step(given, &mut answers);
        }
        let active = self.program.outputs.iter().position(|output| output.path == "active_set");
        active.is_some_and(|active| number(answers[active]) != 0.0)
    }

    /// By how much an output may deviate without a report: by twice the limit of what it adds, by the limit where a fraction that
    /// the caller tunes is 0 for it; where a block starts anew as after a reset, by what its delays hold.
    fn allowed(&self, flipped: usize, output: usize, cycle: usize) -> f64 {
        let limits = if self.program.state[flipped].path.starts_with("tuning.") { 1.0 } else { 2.0 };
        let is_with_addition = WITH_ADDITION.contains(&&*self.program.outputs[output].path);
        let added = if is_with_addition { limits * self.limit } else { 0.0 };
        let held =
            |away: usize| (number(self.outputs[cycle][output]) - number(self.outputs[cycle - away][output])).abs();
        let starts_anew = self.program.state[flipped].path.ends_with("preset");
        let held = if starts_anew { (1..=DELAYS).map(held).fold(0.0, f64::max) } else { 0.0 };
        added + 1.1 * held + 1e-6 * self.largest[output]
    }
}

/// Outputs that count, and so keep what they have lost.
fn is_count(path: &str) -> bool {
    path == "job_number"
}

/// A move to a constant velocity with a vibration; after the flip DRYRUN, a reset, a bad sample, a loss of position control, a refused set.
fn inputs(program: &Program, cycle: usize, designed: &Designed) -> Vec<Literal> {
    let (time, v_max) = (cycle as f64 * designed.axis.cycle_time(), designed.axis.ipc.v_max.max(1000.0));
    let vibration = 0.05 * v_max * (TAU * 21.0 * time).sin();
    let ramp = (cycle as f64 / 200.0).min(1.0);
    let velocity = 0.5 * v_max * ramp;
    let x = 0.5 * v_max * (time - 0.1 * ramp);
    let is_within = |from: usize, length: usize| (from..from + length).contains(&cycle);
    let value = |path: &str| match path {
        "v_motor" | "v_direct" | "v_command" if is_within(2_600, 1) => f64::NAN,
        "v_motor" | "v_direct" | "v_command" => velocity + vibration,
        "v_interpolator" | "v_feedforward" | "v_actual" => velocity,
        "a_interpolator" => vibration * 3.0,
        "j_interpolator" => vibration * 7.0,
        "x_command" => x,
        "x_actual" => x - 0.02 * velocity,
        "following_error" => 0.02 * velocity,
        "v_additive" | "v_add" | "v_add_master" => 0.01 * vibration,
        "tuning_limit" => 0.9,
        path if path.starts_with("tuning_weight") => 0.8,
        _ => 0.0,
    };
    let real = |value: f64| match program.real {
        RealKind::F64 => Literal::F64(value),
        RealKind::F32 => Literal::F32(value as f32),
    };
    let signal = |variable: &compiler::program::Variable| match (variable.path.as_str(), variable.ty) {
        ("params.set_id", _) if is_within(800, 700) => Literal::U32(77),
        _ if program.in_set(variable).is_some() => variable.start,
        (path, Type::Real) => real(value(path)),
        ("mode", _) => Literal::I32(if is_within(1_700, 200) { 2 } else { 1 }),
        ("reset", _) => Literal::Bool(is_within(2_100, 5)),
        ("position_controlled", _) => Literal::Bool(!is_within(2_300, 5)),
        ("feedforward_active" | "drive_on", _) => Literal::Bool(true),
        ("feedforward_percentage", _) => Literal::I32(80),
        _ => variable.start,
    };
    program.inputs.iter().map(signal).collect()
}
