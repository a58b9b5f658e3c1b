//! Runs a program in every engine that needs no compiler, and compares: the Rust itself, then the interpreted program
//! after specialising and after each pass.

use super::defect::Defect;
use super::stimulus;
use super::subject::{Frame, Instance, unset_leaves};
use compiler::interp::Machine;
use compiler::legalise;
use compiler::pass::{self, PASSES, Stage};
use compiler::program::{Expr, Program, Statement, Var};
use portable::Literal;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What came of a program.
pub struct Judgement {
    /// engines that differ, each with what was found
    pub differences: Vec<(String, String)>,
    /// what the run has in it
    pub facts: Vec<&'static str>,
    /// what the C is printed from and compared with; nothing if the program is not to be had
    pub compiled: Option<Compiled>,
}

/// A program after all passes with the answers that it has to give.
pub struct Compiled {
    /// the program
    pub program: Program,
    /// the state before `init`, as far as the program keeps it
    pub unset: Vec<Literal>,
    /// for each run the inputs of each sample
    pub inputs: Vec<Vec<Vec<Literal>>>,
    /// for each run and sample the outputs, then the state that the program keeps
    pub answers: Vec<Vec<Vec<Literal>>>,
}

/// Where the Rust itself breaks off, a program says nothing about the others.
pub const INVALID: &str = "rust";

/// Judges a program; a defect is planted where it says.
#[must_use]
pub fn judge(instance: &Instance, defect: Option<Defect>) -> Judgement {
    let mut judgement = Judgement { differences: Vec::new(), facts: Vec::new(), compiled: None };
    let inputs = stimulus::runs(instance);
    let frames = match attempt(|| inputs.iter().map(|run| (instance.run)(run)).collect::<Vec<_>>()) {
        Ok(frames) => frames,
        Err(message) => {
            judgement.differences.push((INVALID.to_owned(), message));
            return judgement;
        }
    };
    super::facts::of_frames(&frames, &mut judgement.facts);
    if let Err((engine, message)) = stages(instance, &inputs, &frames, defect, &mut judgement) {
        judgement.differences.push((engine, message));
    }
    judgement
}

type Broken = (String, String);

/// An output that somebody who looks between two statements sees with a value of neither this cycle nor the last one, as a language
/// gets the program.
fn torn(program: &Program, passes: &[Stage], runs: &[Vec<Vec<Literal>>]) -> Option<String> {
    let legal = legalise::run(program, passes).unwrap_or_else(|defect| panic!("{defect}"));
    for run in runs {
        let (mut machine, mut outputs) = (Machine::start(&legal), Vec::new());
        for (sample, inputs) in run.iter().enumerate() {
            let mut written = Vec::new();
            machine.step_watched(&numbers(inputs), &mut outputs, &mut |output, value| written.push((output, value)));
            let is_final = |(output, value): &(usize, Literal)| same(*value, outputs[*output]);
            if let Some((output, value)) = written.into_iter().find(|of| !is_final(of)) {
                let path = &legal.outputs[output].path;
                return Some(format!("sample {sample}: {path} is {value:?} for a while, then {:?}", outputs[output]));
            }
        }
    }
    None
}

/// Goes through the stages up to the first that is broken or differs.
fn stages(
    instance: &Instance,
    inputs: &[Vec<Vec<Literal>>],
    frames: &[Vec<Frame>],
    defect: Option<Defect>,
    judgement: &mut Judgement,
) -> Result<(), Broken> {
    let named = |engine: &str| {
        let engine = engine.to_owned();
        move |message| (engine, message)
    };
    let first = attempt(instance.specialise).map_err(named("specialised"))?;
    let whole = Whole { instance, paths: first.state.iter().map(|variable| variable.path.clone()).collect() };
    whole.compare(&first, inputs, frames).map_err(named("specialised"))?;
    let mut program = first;
    for (position, (name, pass)) in PASSES.into_iter().enumerate() {
        let before = program.clone();
        let result = attempt(|| pass(before).map_err(|defect| defect.to_string()));
        let after = result.and_then(|result| result).map_err(named(name))?;
        super::facts::of_pass(name, &program, &after, &mut judgement.facts);
        // A promise that a pass breaks shows at that pass, not at the end of the line.
        pass::verify(after.clone()).map_err(|defect| (name.to_owned(), defect.to_string()))?;
        let planted = if position + 1 == PASSES.len() { defect } else { None };
        let interpreted = super::defect::interpreted(after.clone(), planted);
        if interpreted.step != program.step || interpreted.init != program.init {
            whole.compare(&interpreted, inputs, frames).map_err(named(name))?;
        }
        program = after;
    }
    for passes in [legalise::WITH_OUTPUTS, legalise::WITH_DIGITS] {
        let torn = attempt(|| torn(&program, passes, inputs)).map_err(named("settled"))?;
        if let Some(torn) = torn {
            return Err(("settled".to_owned(), torn));
        }
    }
    let unset = whole.unset(&program);
    let kept = whole.kept(&program);
    let answers = frames.iter().map(|run| run.iter().map(|frame| answer(frame, &kept)).collect()).collect();
    let inputs = inputs.iter().map(|run| run.iter().map(|sample| numbers(sample)).collect()).collect();
    judgement.compiled = Some(Compiled { program, unset, inputs, answers });
    Ok(())
}

/// A program before anything was left out of it.
struct Whole<'i> {
    instance: &'i Instance,
    /// the paths of all parts of the state
    paths: Vec<String>,
}

impl Whole<'_> {
    /// The positions in the whole state of the parts that a program keeps.
    fn kept(&self, program: &Program) -> Vec<usize> {
        let position = |path: &str| self.paths.iter().position(|known| known == path);
        program.state.iter().map(|variable| position(&variable.path).expect("judge: a part of the state")).collect()
    }

    /// What a program's state is before `init`.
    fn unset(&self, program: &Program) -> Vec<Literal> {
        let all = numbers(&unset_leaves(self.instance.state));
        self.kept(program).into_iter().map(|position| all[position]).collect()
    }

    /// Interprets a program and compares outputs and state after every sample.
    fn compare(&self, program: &Program, inputs: &[Vec<Vec<Literal>>], frames: &[Vec<Frame>]) -> Result<(), String> {
        let kept = self.kept(program);
        let mut shown = showing_state(program.clone());
        for (variable, unset) in shown.state.iter_mut().zip(self.unset(program)) {
            variable.start = unset;
        }
        for (run, (samples, frames)) in inputs.iter().zip(frames).enumerate() {
            let found = attempt(|| interpret(&shown, samples))?;
            for (sample, (frame, found)) in frames.iter().zip(&found).enumerate() {
                let answer = answer(frame, &kept);
                let differs = answer.iter().zip(found).position(|(expected, found)| !same(*expected, *found));
                if let Some(at) = differs {
                    let path = &shown.outputs[at].path;
                    let (found, expected) = (found[at], answer[at]);
                    return Err(format!("run {run}, sample {sample}: {path} is {found:?}, in Rust it is {expected:?}"));
                }
            }
        }
        Ok(())
    }
}

fn interpret(program: &Program, samples: &[Vec<Literal>]) -> Vec<Vec<Literal>> {
    let mut machine = Machine::start(program);
    let run = |sample: &Vec<Literal>| {
        let mut outputs = Vec::new();
        machine.step(&numbers(sample), &mut outputs);
        outputs
    };
    samples.iter().map(run).collect()
}

/// The program with the state as further outputs.
fn showing_state(mut program: Program) -> Program {
    let outputs = program.outputs.len();
    program.outputs.extend(program.state.iter().cloned());
    let show = |part| Statement::Assign { target: Var::Output(outputs + part), value: Expr::Var(Var::State(part)) };
    program.step.extend((0..program.state.len()).map(show));
    program
}

/// The outputs, then the parts of the state that are kept.
fn answer(frame: &Frame, kept: &[usize]) -> Vec<Literal> {
    let state = kept.iter().map(|position| frame.state[*position]);
    numbers(&frame.outputs.iter().copied().chain(state).collect::<Vec<_>>())
}

/// Values as a program has them: a variant is its number.
fn numbers(values: &[Literal]) -> Vec<Literal> {
    values.iter().map(|value| value.at_run_time()).collect()
}

/// Whether two values have the same bits; any NaN is as good as any other.
#[must_use]
pub fn same(a: Literal, b: Literal) -> bool {
    match (a, b) {
        (Literal::F64(a), Literal::F64(b)) => a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan(),
        (Literal::F32(a), Literal::F32(b)) => a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan(),
        _ => a == b,
    }
}

/// The result of something that may panic, or what the panic says.
///
/// # Errors
/// It panicked.
pub fn attempt<T>(run: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(run)).map_err(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        text.or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned())).unwrap_or_default()
    })
}
