//! `axgen verify`: every block of every axis, every engine, against the reference, bit by bit.

use crate::arguments::SetArguments;
use crate::exit::Exit;
use crate::input;
use crate::results::{Files, Outcome};
use generator::axis::Axis;
use generator::block::{self, Block};
use golden::compare::{Place, compare};
use golden::engine::{self, ENGINES, Engine, Failure};
use golden::samples::{Samples, Shape};
use golden::{exercise, stimulus};
use indicatif::{ProgressBar, ProgressStyle};

/// Runs the command.
#[expect(clippy::print_stdout, reason = "what the command has found")]
pub fn run(arguments: &SetArguments, samples: usize, files: &Files) -> Result<Exit, Exit> {
    let (set, _) = input::read(arguments)?;
    let mut outcomes = Vec::new();
    println!(
        "{:<20} {:<16} {:<10} {:>10} {:>15}  first difference",
        "axis", "block", "engine", "samples", "differing bits"
    );
    let bar = progress(set.axes.iter().map(|axis| block::names(axis).len()).sum());
    for axis in &set.axes {
        let blocks = block::blocks(axis).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"));
        for (which, block) in blocks.iter().enumerate() {
            let shape = Shape::of(&block.program.inputs, axis.real);
            let inputs = stimulus::samples(&exercise::stimulus(axis, &block.program), &shape, samples)
                .map_err(Exit::environment)?;
            every_engine(axis, &blocks, which, &inputs, &bar, &mut outcomes)?;
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
#[expect(clippy::print_stdout, reason = "what the command has found")]
fn every_engine(
    axis: &Axis,
    blocks: &[Block],
    which: usize,
    inputs: &Samples,
    bar: &ProgressBar,
    outcomes: &mut Vec<Outcome>,
) -> Result<(), Exit> {
    let block = &blocks[which];
    let mut expected: Option<Samples> = None;
    for engine in ENGINES {
        bar.set_message(format!("{} {} {engine}", axis.name, block.program.block));
        let (bits, first) = match engine::run_among(engine, axis, blocks, which, inputs) {
            Ok(found) => {
                let difference = compare(expected.as_ref().unwrap_or(&found), &found);
                expected.get_or_insert(found);
                (difference.bits.to_string(), difference.first.map(place).unwrap_or_default())
            }
            Err(Failure::SelfTest(sample)) => ("-".to_owned(), format!("self-test, sample {sample}")),
            Err(Failure::Broken(text)) => ("-".to_owned(), text),
            Err(Failure::Environment(text)) => return Err(Exit::environment(text)),
            Err(failure) => return Err(Exit::environment(format!("engine {engine}: {failure}"))),
        };
        let failure = (!first.is_empty() || bits != "0").then(|| format!("{bits} differing bits; {first}"));
        let name = format!("{} {engine}", block.program.block);
        outcomes.push(Outcome { group: axis.name.clone(), name, failure });
        let is_reference = if engine == Engine::Reference { "(reference)" } else { &bits };
        let (name, block, samples) = (&axis.name, block.program.block, inputs.len());
        bar.suspend(|| println!("{name:<20} {block:<16} {engine:<10} {samples:>10} {is_reference:>15}  {first}"));
        bar.inc(1);
    }
    Ok(())
}

fn place(place: Place) -> String {
    let Place { sample, signal, expected, found } = place;
    format!("sample {sample}, {signal}: {expected:?} expected, {found:?} found")
}
