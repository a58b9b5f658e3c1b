//! `axgen verify`: every block of every axis, or one block in a scenario, every engine, against the reference, bit by bit.

use crate::arguments::VerifyArguments;
use crate::compiler;
use crate::exit::Exit;
use crate::input;
use crate::messages::Format;
use crate::output;
use crate::results::{Files, Outcome};
use crate::scenario;
use commands::verify::{self, Verification};
use commands::words::made;
use generator::blocks::{self, Block, Designed};
use generator::pipeline::Set;
use golden::engine::Engine;
use golden::exercise;
use golden::samples::Samples;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::Path;

/// The largest number of samples, with inputs and outputs, that a computer's memory can hold.
const MOST_SAMPLES: usize = 10_000_000;

/// The number of samples of each run, at least 1: otherwise nothing would be verified.
pub fn samples(text: &str) -> Result<usize, String> {
    let within = text.parse().ok().filter(|samples| (1..=MOST_SAMPLES).contains(samples));
    within.ok_or_else(|| format!("a whole number from 1 to {MOST_SAMPLES} is allowed"))
}

/// Runs the command: every block of every axis, or one block with the inputs of a scenario.
pub fn run(of: &VerifyArguments, format: Format) -> Result<Exit, Exit> {
    let engines = verify::engines(&of.engines)?;
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

fn every_block<'a>(set: &Set, samples: usize, engines: &'a [Engine], format: Format) -> Result<Run<'a>, Exit> {
    let blocks: usize = set.axes.iter().map(|of| blocks::names(&of.axis).len()).sum();
    let mut run = Run::start(blocks, engines, format)?;
    for designed in &set.axes {
        for block in &made(blocks::blocks(designed)) {
            run.every_engine(designed, block, &exercise::inputs(designed, block, samples))?;
        }
    }
    Ok(run)
}

fn of_scenario<'a>(
    set: &Set,
    program: &Path,
    of: &VerifyArguments,
    engines: &'a [Engine],
    format: Format,
) -> Result<Run<'a>, Exit> {
    let designed = commands::axis(set, of.axis.as_deref())?;
    let block = commands::scenario::block(designed, of.block.as_deref())?;
    let options = scenario::options(&of.moved_by);
    let inputs = scenario::made(program, designed, &block, &options, format)?.inputs;
    let mut run = Run::start(1, engines, format)?;
    run.every_engine(designed, &block, &inputs)?;
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
struct Run<'a> {
    outcomes: Vec<Outcome>,
    verification: Verification<'a>,
    bar: ProgressBar,
}

impl<'a> Run<'a> {
    /// Prints the head of the table of this number of runs.
    fn start(runs: usize, engines: &'a [Engine], format: Format) -> Result<Self, Exit> {
        output::line(verify::head())?;
        let verification = Verification::new(engines, &compiler::broken);
        Ok(Self { outcomes: Vec::new(), verification, bar: progress(runs * engines.len(), format) })
    }

    /// Writes the results. A missing engine is reported at the end, after the others have run.
    fn end(self, files: &Files) -> Result<Exit, Exit> {
        self.bar.finish_and_clear();
        files.write("axgen verify", &self.outcomes)?;
        if self.outcomes.iter().any(|outcome| outcome.failure.is_some()) {
            return Ok(Exit::Different);
        }
        let report = self.verification.missing();
        if report.has_errors() { Err(Exit::Environment(report)) } else { Ok(Exit::Done) }
    }

    /// Prints a line for each engine, and stores its result.
    fn every_engine(&mut self, designed: &Designed, block: &Block, inputs: &Samples) -> Result<(), Exit> {
        let Self { outcomes, verification, bar } = self;
        bar.set_message(format!("{} {}", designed.axis.name, block.program.block));
        let reached = verification.block(designed, block, inputs, |row| {
            if !row.is_missing {
                let name = format!("{} {}", row.block, row.engine);
                outcomes.push(Outcome { group: row.axis.clone(), name, failure: row.failure() });
            }
            bar.suspend(|| output::line(row.text()))?;
            bar.inc(1);
            Ok::<_, Exit>(())
        })?;
        reached.into_iter().try_for_each(|line| bar.suspend(|| output::line(line)))
    }
}
