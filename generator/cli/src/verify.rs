//! `axgen verify`: every block of every axis, or one block in a scenario, every engine, against the reference, bit by bit.

use crate::arguments::VerifyArguments;
use crate::compiler;
use crate::exit::Exit;
use crate::input;
use crate::messages::Format;
use crate::output;
use crate::results::{Files, Outcome};
use crate::run::engine_named;
use crate::scenario;
use generator::blocks::Designed;
use generator::blocks::{self, Block};
use generator::codes;
use generator::diagnostics::{Diagnostic, Place, Report};
use generator::pipeline::Set;
use golden::compare::{FirstDifference, compare};
use golden::engine::{self, ENGINES, Engine, Failure};
use golden::exercise::{self, coverage::coverage};
use golden::samples::Samples;
use indicatif::{ProgressBar, ProgressStyle};
use std::collections::BTreeMap;
use std::path::Path;

/// The largest number of samples, with inputs and outputs, that a computer's memory can hold.
const MOST_SAMPLES: usize = 10_000_000;

/// The number of samples of each run, at least 1: otherwise nothing would be verified.
pub fn samples(text: &str) -> Result<usize, String> {
    let within = text.parse().ok().filter(|samples| (1..=MOST_SAMPLES).contains(samples));
    within.ok_or_else(|| format!("a whole number from 1 to {MOST_SAMPLES} is allowed"))
}

/// The engines of these names, preceded by the reference; all if there is no name.
fn chosen(names: &[String]) -> Result<Vec<Engine>, Exit> {
    let engines = names.iter().map(|name| engine_named(name)).collect::<Result<Vec<_>, _>>()?;
    let is_chosen = |engine: &Engine| *engine == Engine::Reference || engines.is_empty() || engines.contains(engine);
    Ok(ENGINES.into_iter().filter(is_chosen).collect())
}

/// Runs the command: every block of every axis, or one block with the inputs of a scenario.
pub fn run(of: &VerifyArguments, format: Format) -> Result<Exit, Exit> {
    let engines = chosen(&of.engines)?;
    let (set, _) = input::read(&of.set, format)?;
    of.results.kept_apart(Some(&of.set.set))?;
    match &of.scenario {
        None => every_block(&set, of.samples, &engines, format)?,
        Some(program) => {
            of.results.kept_apart(Some(program))?;
            of_scenario(&set, program, of, &engines, format)?
        }
    }
    .end(&of.results)
}

fn every_block(set: &Set, samples: usize, engines: &[Engine], format: Format) -> Result<Run, Exit> {
    let blocks: usize = set.axes.iter().map(|of| blocks::names(&of.axis).len()).sum();
    let mut run = Run::start(blocks * engines.len(), format)?;
    for designed in &set.axes {
        let blocks = blocks::blocks(designed).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"));
        for block in &blocks {
            run.every_engine(engines, designed, block, &exercise::inputs(designed, block, samples))?;
        }
    }
    Ok(run)
}

fn of_scenario(
    set: &Set,
    program: &Path,
    of: &VerifyArguments,
    engines: &[Engine],
    format: Format,
) -> Result<Run, Exit> {
    let designed = input::axis(set, of.axis.as_deref())?;
    let block = scenario::block_of_scenario(designed, of.block.as_deref())?;
    let options = scenario::options(&of.moved_by);
    let inputs = scenario::made(program, designed, &block, &options, format)?.inputs;
    let mut run = Run::start(engines.len(), format)?;
    run.every_engine(engines, designed, &block, &inputs)?;
    Ok(run)
}

/// The progress, on a terminal only. For programs standard error contains only objects.
fn progress(runs: usize, format: Format) -> ProgressBar {
    if format == Format::Json {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(runs as u64);
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}

/// The results of the runs.
struct Run {
    outcomes: Vec<Outcome>,
    /// the missing engines, and the reasons
    missing: BTreeMap<Engine, String>,
    bar: ProgressBar,
}

impl Run {
    /// Prints the head of the table of this number of runs.
    fn start(runs: usize, format: Format) -> Result<Self, Exit> {
        output::line(format!(
            "{:<20} {:<16} {:<10} {:>10} {:>15}  first difference",
            "axis", "block", "engine", "samples", "differing bits"
        ))?;
        Ok(Self { outcomes: Vec::new(), missing: BTreeMap::new(), bar: progress(runs, format) })
    }

    /// Writes the results. A missing engine is reported at the end, after the others have run.
    fn end(self, files: &Files) -> Result<Exit, Exit> {
        self.bar.finish_and_clear();
        files.write("axgen verify", &self.outcomes)?;
        if self.outcomes.iter().any(|outcome| outcome.failure.is_some()) {
            return Ok(Exit::Different);
        }
        let missing = self.missing.into_iter();
        let diagnostics: Vec<Diagnostic> = missing
            .map(|(engine, why)| Diagnostic::error(codes::NO_ENGINE, Place::whole(format!("engine {engine}")), why))
            .collect();
        let report = Report { diagnostics };
        if report.has_errors() { Err(Exit::Environment(report)) } else { Ok(Exit::Done) }
    }

    /// Prints a line for each engine, and stores its result.
    fn every_engine(
        &mut self,
        engines: &[Engine],
        designed: &Designed,
        block: &Block,
        inputs: &Samples,
    ) -> Result<(), Exit> {
        let (axis, of_block) = (&designed.axis.name, block.program.block);
        let mut expected: Option<Samples> = None;
        for &engine in engines {
            self.bar.set_message(format!("{axis} {of_block} {engine}"));
            let is_missing = self.missing.contains_key(&engine);
            let found = (!is_missing).then(|| engine::run(engine, designed, block, inputs));
            let (bits, first) = self.judge(engine, found, &mut expected);
            if !self.missing.contains_key(&engine) {
                let differs = !first.is_empty() || bits != "0";
                let failure = differs.then(|| format!("{bits} differing bits; {first}"));
                self.outcomes.push(Outcome { group: axis.clone(), name: format!("{of_block} {engine}"), failure });
            }
            let bits = if engine == Engine::Reference { "(reference)" } else { &bits };
            let samples = inputs.len();
            let row = format!("{axis:<20} {of_block:<16} {engine:<10} {samples:>10} {bits:>15}  {first}");
            self.bar.suspend(|| output::line(row))?;
            self.bar.inc(1);
        }
        if let Some(outputs) = expected {
            let reached = coverage(designed, block, inputs, &outputs);
            let line = format!("{axis:<20} {of_block:<16} reached: {reached}");
            let missing = reached.missing().map(|line| format!("{:<20} {:<16}   {line}", "", ""));
            for line in [line].into_iter().chain(missing) {
                self.bar.suspend(|| output::line(line))?;
            }
        }
        Ok(())
    }

    /// The number of differing bits of an engine, and the first difference. Without a result, the engine is missing.
    fn judge(
        &mut self,
        engine: Engine,
        found: Option<Result<Samples, Failure>>,
        expected: &mut Option<Samples>,
    ) -> (String, String) {
        let none = "-".to_owned();
        match found {
            Some(Ok(found)) => {
                let difference = compare(expected.as_ref().unwrap_or(&found), &found);
                expected.get_or_insert(found);
                (difference.bits.to_string(), difference.first.map(place).unwrap_or_default())
            }
            Some(Err(Failure::SelfTest(sample))) => (none, format!("self-test, sample {sample}")),
            Some(Err(Failure::Broken(text))) if compiler::works(engine) => (none, text),
            Some(Err(failure)) => {
                let why = match failure {
                    Failure::Broken(text) => compiler::broken(engine, &text),
                    failure => failure.to_string(),
                };
                self.missing.insert(engine, why);
                (none, NOT_RUN.to_owned())
            }
            None => (none, NOT_RUN.to_owned()),
        }
    }
}

/// The text in the row of a missing engine.
const NOT_RUN: &str = "not run";

fn place(place: FirstDifference) -> String {
    let FirstDifference { sample, signal, expected, found } = place;
    format!("sample {sample}, {signal}: {expected:?} expected, {found:?} found")
}
