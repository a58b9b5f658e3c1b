//! `axgen verify`: every block of every axis, every engine, against the reference, bit by bit.

use crate::arguments::SetArguments;
use crate::compiler;
use crate::exit::Exit;
use crate::input;
use crate::messages::Format;
use crate::output;
use crate::results::{Files, Outcome};
use generator::blocks::Designed;
use generator::blocks::{self, Block};
use generator::codes;
use golden::compare::{FirstDifference, compare};
use golden::engine::{self, ENGINES, Engine, Failure};
use golden::samples::{Samples, Shape};
use golden::{exercise, stimulus};
use indicatif::{ProgressBar, ProgressStyle};

/// How many samples each run has: without any, nothing would be verified.
pub fn samples(text: &str) -> Result<usize, &'static str> {
    text.parse().ok().filter(|samples| *samples > 0).ok_or("a whole number from 1 on is allowed")
}

/// Runs the command.
pub fn run(arguments: &SetArguments, format: Format, samples: usize, files: &Files) -> Result<Exit, Exit> {
    let (set, _) = input::read(arguments, format)?;
    files.kept_apart(&arguments.set)?;
    let mut outcomes = Vec::new();
    output::line(format!(
        "{:<20} {:<16} {:<10} {:>10} {:>15}  first difference",
        "axis", "block", "engine", "samples", "differing bits"
    ))?;
    let blocks = set.axes.iter().map(|of| blocks::names(&of.axis).len()).sum();
    // Machines have nothing but objects on standard error.
    let bar = if format == Format::Json { ProgressBar::hidden() } else { progress(blocks) };
    for designed in &set.axes {
        let axis = &designed.axis;
        let blocks = blocks::blocks(designed).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"));
        for (which, block) in blocks.iter().enumerate() {
            let shape = Shape::of(&block.program.inputs, axis.real);
            let inputs = stimulus::samples(&exercise::stimulus(axis, &block.program), &shape, samples)
                .unwrap_or_else(|mistake| panic!("a defect of axgen: {mistake}"));
            every_engine(designed, &blocks, which, &inputs, &bar, &mut outcomes)?;
        }
    }
    bar.finish_and_clear();
    files.write("axgen verify", &outcomes)?;
    Ok(if outcomes.iter().all(|outcome| outcome.failure.is_none()) { Exit::Done } else { Exit::Different })
}

/// How far it is, on a terminal; elsewhere nothing.
fn progress(blocks: usize) -> ProgressBar {
    let bar = ProgressBar::new((blocks * ENGINES.len()) as u64);
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}

/// Prints a line for each engine, and notes what came of it.
fn every_engine(
    designed: &Designed,
    blocks: &[Block],
    which: usize,
    inputs: &Samples,
    bar: &ProgressBar,
    outcomes: &mut Vec<Outcome>,
) -> Result<(), Exit> {
    let (axis, block) = (&designed.axis, &blocks[which]);
    let mut expected: Option<Samples> = None;
    for engine in ENGINES {
        bar.set_message(format!("{} {} {engine}", axis.name, block.program.block));
        let (bits, first) = match engine::run_among(engine, designed, blocks, which, inputs) {
            Ok(found) => {
                let difference = compare(expected.as_ref().unwrap_or(&found), &found);
                expected.get_or_insert(found);
                (difference.bits.to_string(), difference.first.map(place).unwrap_or_default())
            }
            Err(Failure::SelfTest(sample)) => ("-".to_owned(), format!("self-test, sample {sample}")),
            Err(Failure::Broken(text)) if engine != Engine::C || compiler::works() => ("-".to_owned(), text),
            Err(Failure::Broken(text)) => {
                return Err(Exit::environment(codes::NO_ENGINE, "engine c", compiler::broken(&text)));
            }
            Err(failure) => return Err(Exit::environment(codes::NO_ENGINE, format!("engine {engine}"), failure)),
        };
        let failure = (!first.is_empty() || bits != "0").then(|| format!("{bits} differing bits; {first}"));
        let name = format!("{} {engine}", block.program.block);
        outcomes.push(Outcome { group: axis.name.clone(), name, failure });
        let is_reference = if engine == Engine::Reference { "(reference)" } else { &bits };
        let (name, block, samples) = (&axis.name, block.program.block, inputs.len());
        let row = format!("{name:<20} {block:<16} {engine:<10} {samples:>10} {is_reference:>15}  {first}");
        bar.suspend(|| output::line(row))?;
        bar.inc(1);
    }
    Ok(())
}

fn place(place: FirstDifference) -> String {
    let FirstDifference { sample, signal, expected, found } = place;
    format!("sample {sample}, {signal}: {expected:?} expected, {found:?} found")
}
