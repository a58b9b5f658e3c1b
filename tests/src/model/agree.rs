//! One random set through the model and through the reference: the first disagreement in words, and how often rounding left
//! a choice. No formula of a block is here.

use super::axis::{Axis, Found};
use super::coefficients::Coefficients;
use super::history::{History, Inputs};
use super::parameters::Parameters;
use super::rounding::Expected;
use super::subject::{self, Run};
use super::{feedforward, position_control, random};
use crate::random::rng::Rng;
use std::ops::AddAssign;

/// What was compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// block runs
    pub runs: u64,
    /// loops that the watch found unstable
    pub trips: u64,
    /// integers, flags and ids in double precision
    pub integers: u64,
    /// those of them with a choice: the exact value lies within rounding of a tie or of a limit
    pub choices: u64,
    /// the same in single precision
    pub integers_in_single: u64,
    /// the same in single precision
    pub choices_in_single: u64,
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.runs += other.runs;
        self.trips += other.trips;
        self.integers += other.integers;
        self.choices += other.choices;
        self.integers_in_single += other.integers_in_single;
        self.choices_in_single += other.choices_in_single;
    }
}

/// Compares one set for so many cycles.
///
/// # Errors
/// The first disagreement: the set, the cycle, the signal, both values.
pub fn set(seed: u64, index: usize, cycles: usize) -> Result<Tally, String> {
    let mut rng = Rng::numbered(seed, index);
    let parameters = random::parameters(&mut rng);
    compare(&parameters, &rng, cycles)
        .map_err(|text| format!("set {index} of seed {seed}: {text}\n{}", parameters.set()))
}

fn compare(p: &Parameters, rng: &Rng, cycles: usize) -> Result<Tally, String> {
    let axis = subject::read(&p.set());
    let blocks = subject::blocks(&axis);
    let c = Coefficients::new(p);
    let is_there = blocks.each_ref().map(Option::is_some);
    let asked = asked(p);
    if is_there != asked {
        return Err(format!("the blocks feedforward, position_control, axis: expected {asked:?}, found {is_there:?}"));
    }
    let mut tally = Tally::default();
    let [of_feedforward, of_control, of_axis] = blocks;
    let mut run = |name: &str, block: Option<Run>, model: &mut Model<'_>| match block {
        Some(block) => one(p, name, block, History::new(p, rng.clone()), cycles, model, &mut tally),
        None => Ok(()),
    };
    let mut alone = feedforward::Alone::default();
    run("feedforward", of_feedforward, &mut |inputs, _| alone.cycle(p, &c, inputs))?;
    let mut alone = position_control::Alone::default();
    run("position_control", of_control, &mut |inputs, found| alone.cycle(p, &c, inputs, found.held))?;
    let mut whole = Axis::new(p, &c, axis.ipc.sum_limit);
    run("axis", of_axis, &mut |inputs, found| whole.cycle(p, &c, inputs, found))?;
    Ok(tally)
}

/// Which of the three blocks an axis has (docs/position-control.md, "Which blocks an axis gets").
fn asked(p: &Parameters) -> [bool; 3] {
    use super::parameters::Location;
    let has_control =
        p.kv.is_some() || p.word != 0 || p.location() != Location::Cnc && !p.stages.is_empty() || p.master.is_some();
    [p.word != 0, has_control, has_control]
}

type Model<'m> = dyn FnMut(&Inputs, Found) -> Expected + 'm;

fn one(
    p: &Parameters,
    name: &str,
    mut block: Run,
    mut history: History,
    cycles: usize,
    model: &mut Model<'_>,
    tally: &mut Tally,
) -> Result<(), String> {
    let mut outputs = Vec::new();
    let mut held = 0.0;
    let (mut before, mut was_tripped) = (None, false);
    tally.runs += 1;
    for cycle in 0..cycles {
        let inputs = history.advance();
        block(&inputs, &mut outputs);
        let output = |name: &str| outputs.iter().find(|(signal, _)| *signal == name).map_or(0.0, |(_, value)| *value);
        let found = Found {
            held,
            v_command: output("v_command"),
            v_add: output("v_add"),
            calculated: output("v_add_calculated"),
            is_disturbed: [3.0, 11.0, 12.0, 13.0].map(f64::to_bits).contains(&output("error_id").to_bits()),
            is_tripped: output("tripped") > 0.0,
        };
        for (signal, [from, to]) in model(&inputs, found) {
            let value = output(signal);
            if !(from <= value && value <= to) {
                return Err(format!(
                    "block {name}, cycle {cycle}, {signal}: the model has {from} to {to}, the reference {value}\n\
                     inputs {inputs:?}\nbefore {before:?}\noutputs {outputs:?}"
                ));
            }
            if !REALS.contains(&signal) {
                let (integers, choices) = if p.single {
                    (&mut tally.integers_in_single, &mut tally.choices_in_single)
                } else {
                    (&mut tally.integers, &mut tally.choices)
                };
                *integers += 1;
                *choices += u64::from(from < to);
            }
        }
        held = output("x_drive");
        tally.trips += u64::from(found.is_tripped && !was_tripped);
        was_tripped = found.is_tripped;
        before = Some(inputs);
    }
    Ok(())
}

/// Outputs that are no integers.
const REALS: [&str; 6] = ["v_command", "v_feedforward", "v_additive", "v_add", "v_add_calculated", "x_drive"];
