//! The answers of the reference in a trial, recorded once for all dialects.

use super::run::Run;
use super::trial::Trial;
use compiler::print::st::literal;
use compiler::program::{Off, Program};
use portable::{Brake, Literal};
use std::sync::{Arc, LazyLock};

/// The answer of the reference in a sample.
#[derive(Clone, Debug)]
pub(crate) struct Answer {
    pub(crate) sample: usize,
    /// whether it is turned off
    pub(crate) is_off: bool,
    /// whether it is turned off and has to be called on
    pub(crate) is_busy: bool,
    /// all outputs; the sign of a zero is not compared
    pub(crate) outputs: Vec<Literal>,
    /// the positions of the outputs that differ from the previous answer, with their values as Structured Text
    pub(crate) changes: Vec<(usize, String)>,
}

/// A reference before its first cycle, made where it is needed.
pub(crate) type Start = Box<dyn FnOnce() -> Box<dyn Run> + Send>;

/// The answers, recorded where they are first looked at: not every target prints them.
pub(crate) type RecordedAnswers = Arc<LazyLock<Vec<Answer>, Box<dyn FnOnce() -> Vec<Answer> + Send>>>;

/// The recording, which runs the reference on first use; `state_paths` are the paths of all leaves of its state.
pub(crate) fn recording(trial: Trial, program: &Program, state_paths: &[String], start: Start) -> RecordedAnswers {
    let works = Works::of(program, state_paths);
    Arc::new(LazyLock::new(Box::new(move || record(&trial, &mut *start(), works))))
}

fn record(trial: &Trial, run: &mut dyn Run, works: Works) -> Vec<Answer> {
    let (mut outputs, mut answers) = (Vec::new(), Vec::<Answer>::new());
    for (sample, inputs) in trial.inputs().into_iter().enumerate() {
        run.step(&inputs, &mut outputs);
        if trial.compares(sample) {
            let outputs: Vec<Literal> = outputs.iter().copied().map(unsigned_zero).collect();
            let before = answers.last();
            let change = |(at, value): (usize, &Literal)| {
                let differs = before.is_none_or(|before| before.outputs[at] != *value);
                differs.then(|| (at, literal(*value)))
            };
            let is_off = trial.holding(sample).any(|turn| turn.is_off);
            answers.push(Answer {
                sample,
                is_off,
                is_busy: is_off && works.shows(run, &inputs, &outputs),
                changes: outputs.iter().enumerate().filter_map(change).collect(),
                outputs,
            });
        }
    }
    answers
}

/// The value; a zero without its sign.
fn unsigned_zero(value: Literal) -> Literal {
    match value {
        // -0 + 0 is 0.
        Literal::F64(value) => Literal::F64(value + 0.0),
        Literal::F32(value) => Literal::F32(value + 0.0),
        other => other,
    }
}

/// The signals that show that a block that was turned off is not at rest yet.
#[derive(Clone, Copy)]
enum Works {
    Never,
    /// a part of the state
    State(usize),
    /// two outputs, and the drive
    Brakes {
        velocity: usize,
        state: usize,
        resting: &'static [i32],
        drive: (usize, i32),
    },
}

impl Works {
    fn of(program: &Program, state_paths: &[String]) -> Self {
        let output = |path: &str| program.outputs.iter().position(|output| output.path == path);
        let found = match program.switch.as_ref().map(|switch| &switch.off) {
            Some(Off::Mode(_, Some(fades)) | Off::Execute(Some(fades))) => {
                state_paths.iter().position(|path| path == program.path(*fades)).map(Self::State)
            }
            Some(Off::Brake(Brake { velocity, state, resting, drive: (input, number) })) => {
                let drive = program.inputs.iter().position(|variable| variable.path == *input);
                let found = output(velocity).zip(output(state)).zip(drive);
                found.map(|((velocity, state), drive)| Self::Brakes {
                    velocity,
                    state,
                    resting,
                    drive: (drive, *number),
                })
            }
            Some(Off::Mode(_, None) | Off::Execute(None) | Off::False) | None => None,
        };
        found.unwrap_or(Self::Never)
    }

    fn shows(self, run: &dyn Run, inputs: &[Literal], outputs: &[Literal]) -> bool {
        match self {
            Self::Never => false,
            Self::State(leaf) => {
                let mut fades = false;
                run.state(&[leaf], &mut |value| fades = value == Literal::Bool(true));
                fades
            }
            Self::Brakes { velocity, state, resting, drive: (drive, in_off) } => {
                let is_off = inputs[drive] == Literal::Bool(false);
                let stands = matches!(outputs[velocity], Literal::F64(0.0) | Literal::F32(0.0));
                let rests = matches!(outputs[state], Literal::I32(number) if resting.contains(&number) || is_off && number == in_off);
                !(stands && rests)
            }
        }
    }
}
