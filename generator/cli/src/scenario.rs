//! `axgen scenario`: an NC program on one axis, as a stimulus and as a picture; and the scenarios of `run` and `verify`.

use crate::arguments::{ProgramArguments, ScenarioArguments};
use crate::exit::Exit;
use crate::input;
use crate::messages::Format;
use crate::one_file::{self, Rule};
use crate::output;
use commands::scenario;
use generator::blocks::{Block, Designed};
use generator::config;
use generator::diagnostics::Slashes;
use golden::csv::{self, Reals};
use golden::samples::Samples;
use golden::scenario::{MOST, Options, Scenario, picture};
use std::path::Path;

/// Runs the command.
pub fn run(of: &ScenarioArguments, format: Format) -> Result<Exit, Exit> {
    let (set, _) = input::read_to_look_at(&of.subject.set, of.drive.keys(of.subject.axis.as_deref()), format)?;
    let designed = commands::axis(&set, of.subject.axis.as_deref())?;
    let block = scenario::block(designed, of.block.as_deref())?;
    let outputs = [of.stimulus.as_deref(), of.picture.as_deref()];
    let outputs: Vec<&Path> = outputs.into_iter().flatten().collect();
    one_file::told_apart(&outputs)?;
    for out in outputs {
        one_file::kept_apart(out, [of.subject.set.set.as_path(), &of.scenario])?;
    }
    let scenario = made(&of.scenario, designed, &block, &options(&of.moved_by), format)?;
    let stimulus = csv::write(&[&scenario.inputs.without_constant()], Reals::Decimal);
    let name = of.scenario.file_stem().unwrap_or_default().to_string_lossy();
    let drawn = picture::of(&scenario, &name, designed).svg();
    // An earlier stimulus has signals of the block in its first line; an earlier picture was written by axgen.
    let is_stimulus = |found: &[u8]| is_header(found, &scenario.inputs);
    let [of_stimulus, of_picture] = [Rule::earlier_output(of.force, &is_stimulus), Rule::earlier_picture(of.force)];
    let stimulus = of.stimulus.as_deref().map(|path| one_file::stage(path, stimulus.as_bytes(), of_stimulus));
    let picture = of.picture.as_deref().map(|path| one_file::stage(path, drawn.as_bytes(), of_picture));
    let staged = [stimulus.transpose()?, picture.transpose()?];
    one_file::commit(staged.into_iter().flatten())?;
    output::print(scenario::table(&scenario, designed, &block))?;
    let Some(message) = scenario.oscillation.message() else { return Ok(Exit::Done) };
    output::print(format!("{message}\n"))?;
    Ok(if scenario.oscillation.is_stable == Some(true) { Exit::Done } else { Exit::Different })
}

/// Whether a file begins with the names of some of these signals, as a stimulus does.
fn is_header(found: &[u8], inputs: &Samples) -> bool {
    let first = found.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let is_signal = |name: &[u8]| inputs.shape.signals.iter().any(|signal| signal.name.as_bytes() == name);
    first.split(|byte| *byte == b',').all(is_signal)
}

/// The options of a program, from the command line.
pub fn options(of: &ProgramArguments) -> Options {
    let usual = Options::default();
    Options { program_axis: of.program_axis.clone(), cycles: of.cycles.unwrap_or(usual.cycles) }
}

/// A number of cycles that fits into memory.
pub fn cycles(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|cycles| (1..=MOST).contains(cycles)).ok_or(format!("1 to {MOST} is allowed"))
}

/// The scenario of a program on an axis. Parts of the program that do not act as written are warnings on standard error.
pub fn made(
    program: &Path,
    designed: &Designed,
    block: &Block,
    options: &Options,
    format: Format,
) -> Result<Scenario, Exit> {
    let file = program.slashes();
    let bytes = config::load(program).map_err(|unreadable| Exit::Input(unreadable.diagnostic(&file).into()))?;
    let (scenario, report) = scenario::run((&file, bytes), designed, block, options)?;
    input::said(Some(scenario), &report, format)
}
