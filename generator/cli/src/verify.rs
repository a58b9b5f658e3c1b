//! `axgen verify`: every block of every axis, or one block in a scenario, every engine, against the reference, bit by bit.

use crate::arguments::SetArguments;
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
use golden::compare::{FirstDifference, compare};
use golden::engine::{self, ENGINES, Engine, Failure};
use golden::exercise::{self, coverage::coverage};
use golden::samples::Samples;
use indicatif::{ProgressBar, ProgressStyle};
use std::collections::BTreeMap;
use std::path::PathBuf;

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

/// Runs the command on every block of every axis.
pub fn run(
    arguments: &SetArguments,
    format: Format,
    samples: usize,
    engines: &[String],
    files: &Files,
) -> Result<Exit, Exit> {
    let engines = chosen(engines)?;
    let (set, _) = input::read(arguments, format)?;
    files.kept_apart(Some(&arguments.set))?;
    let blocks: usize = set.axes.iter().map(|of| blocks::names(&of.axis).len()).sum();
    let mut run = Run::start()?;
    let bar = progress(blocks * engines.len(), format);
    for designed in &set.axes {
        let blocks = blocks::blocks(designed).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"));
        for block in &blocks {
            let inputs = exercise::inputs(designed, block, samples);
            run.every_engine(&engines, designed, block, &inputs, &bar)?;
        }
    }
    bar.finish_and_clear();
    run.end(files)
}

/// The scenario of one block.
pub struct Scenario {
    /// the NC program
    pub program: PathBuf,
    /// the axis; `None` for the only one
    pub axis: Option<String>,
    /// the block; `None` for the usual one of the axis
    pub block: Option<String>,
    /// the options of the program
    pub options: golden::scenario::Options,
}

/// Runs the command on one block, with the inputs of a scenario.
pub fn run_scenario(
    arguments: &SetArguments,
    format: Format,
    request: &Scenario,
    engines: &[String],
    files: &Files,
) -> Result<Exit, Exit> {
    let engines = chosen(engines)?;
    let (set, _) = input::read(arguments, format)?;
    files.kept_apart(Some(&arguments.set))?;
    files.kept_apart(Some(&request.program))?;
    let designed = input::axis(&set, request.axis.as_deref())?;
    let block = scenario::block_of_scenario(designed, request.block.as_deref())?;
    let inputs = scenario::made(&request.program, designed, &block, &request.options, format)?.inputs;
    let mut run = Run::start()?;
    let bar = progress(engines.len(), format);
    run.every_engine(&engines, designed, &block, &inputs, &bar)?;
    bar.finish_and_clear();
    run.end(files)
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
}

impl Run {
    /// Prints the head of the table.
    fn start() -> Result<Self, Exit> {
        output::line(format!(
            "{:<20} {:<16} {:<10} {:>10} {:>15}  first difference",
            "axis", "block", "engine", "samples", "differing bits"
        ))?;
        Ok(Self { outcomes: Vec::new(), missing: BTreeMap::new() })
    }

    /// Writes the results. A missing engine is reported at the end, after the others have run.
    fn end(self, files: &Files) -> Result<Exit, Exit> {
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
        bar: &ProgressBar,
    ) -> Result<(), Exit> {
        let axis = &designed.axis;
        let mut expected: Option<Samples> = None;
        for &engine in engines {
            bar.set_message(format!("{} {} {engine}", axis.name, block.program.block));
            let is_missing = self.missing.contains_key(&engine);
            let found = if is_missing { None } else { Some(engine::run(engine, designed, block, inputs)) };
            let (bits, first) = match found {
                Some(Ok(found)) => {
                    let difference = compare(expected.as_ref().unwrap_or(&found), &found);
                    expected.get_or_insert(found);
                    (difference.bits.to_string(), difference.first.map(place).unwrap_or_default())
                }
                Some(Err(Failure::SelfTest(sample))) => ("-".to_owned(), format!("self-test, sample {sample}")),
                Some(Err(Failure::Broken(text))) if compiler::works(engine) => ("-".to_owned(), text),
                Some(Err(failure)) => {
                    let why = match failure {
                        Failure::Broken(text) => compiler::broken(engine, &text),
                        failure => failure.to_string(),
                    };
                    self.missing.insert(engine, why);
                    ("-".to_owned(), NOT_RUN.to_owned())
                }
                None => ("-".to_owned(), NOT_RUN.to_owned()),
            };
            let name = format!("{} {engine}", block.program.block);
            let is_run = !self.missing.contains_key(&engine);
            let failure =
                (is_run && (!first.is_empty() || bits != "0")).then(|| format!("{bits} differing bits; {first}"));
            if is_run {
                self.outcomes.push(Outcome { group: axis.name.clone(), name, failure });
            }
            let is_reference = if engine == Engine::Reference { "(reference)" } else { &bits };
            let (name, block, samples) = (&axis.name, block.program.block, inputs.len());
            let row = format!("{name:<20} {block:<16} {engine:<10} {samples:>10} {is_reference:>15}  {first}");
            bar.suspend(|| output::line(row))?;
            bar.inc(1);
        }
        if let Some(outputs) = expected {
            let reached = coverage(designed, block, inputs, &outputs);
            let line = format!("{:<20} {:<16} reached: {reached}", axis.name, block.program.block);
            let missing = reached.missing().map(|line| format!("{:<20} {:<16}   {line}", "", ""));
            for line in [line].into_iter().chain(missing) {
                bar.suspend(|| output::line(line))?;
            }
        }
        Ok(())
    }
}

/// The text in the row of a missing engine.
const NOT_RUN: &str = "not run";

fn place(place: FirstDifference) -> String {
    let FirstDifference { sample, signal, expected, found } = place;
    format!("sample {sample}, {signal}: {expected:?} expected, {found:?} found")
}
