//! `axgen run`: one block, one engine, samples from a CSV file to a CSV file, or compared with a recording.

use crate::arguments::RunArguments;
use crate::exit::Exit;
use crate::given::{self, name_of};
use crate::input;
use crate::messages::{self, Format};
use crate::one_file::{self, Rule};
use crate::output;
use commands::compared;
use commands::verify::engine_named;
use generator::codes;
use golden::csv::{self, Reals};
use golden::engine;
use golden::evidence;
use golden::samples::{Samples, Shape};
use std::path::Path;

/// A column and its signal.
pub fn mapping(text: &str) -> Result<(String, String), &'static str> {
    let (column, signal) = text.rsplit_once('=').ok_or("SCOPE=SIGNAL is allowed: MAIN.x.v_add=v_add")?;
    Ok((column.to_owned(), signal.to_owned()))
}

/// Runs the command.
pub fn run(of: &RunArguments, format: Format) -> Result<Exit, Exit> {
    let (set, _) = input::read(&of.subject.set, format)?;
    let designed = commands::axis(&set, of.subject.axis.as_deref())?;
    let block = commands::block(designed, &of.block)?;
    let engine = engine_named(&of.engine)?;
    let out = of.out.as_deref().filter(|out| !is_standard(out));
    // An earlier output has the same first line.
    let (outputs, recorded) = (Shape::of(&block.program.outputs, block.program.real), block.recorded_outputs());
    let head = csv::write(&[&Samples::with_capacity(outputs, 0).only(&recorded)], Reals::Decimal);
    let is_output = |found: &[u8]| found.starts_with(head.as_bytes());
    let rule = Rule::earlier_output(of.force, &is_output);
    if let Some(out) = out {
        let RunArguments { stimulus, scenario, compare, .. } = of;
        let inputs = [Some(of.subject.set.set.as_path()), stimulus.as_deref(), scenario.as_deref(), compare.as_deref()];
        one_file::kept_apart(out, inputs.into_iter().flatten())?;
        rule.allows(out)?;
    }
    let given::Given { inputs, given, recording } = given::read(of, designed, &block, format)?;
    let found = engine::run(engine, designed, &block, &inputs)
        .map_err(|failure| Exit::environment(codes::NO_ENGINE, format!("engine {engine}"), failure))?;
    let text = || csv::write(&[&found.only(&recorded)], if of.hex { Reals::Hexadecimal } else { Reals::Decimal });
    match out {
        Some(out) => one_file::write(Some(out), text().as_bytes(), rule)?,
        None if recording.is_none() || of.out.is_some() => output::print(text())?,
        None => {}
    }
    let (Some(recording), Some(file)) = (recording, of.compare.as_deref()) else { return Ok(Exit::Done) };
    let evidence = evidence::of(&inputs, &given, &block.for_axis.inputs, &recording);
    let others = set.axes.iter().filter(|other| other.axis.name != designed.axis.name).collect();
    let subject = compared::Subject { designed, block: &block, engine, others };
    compared::evidence(&evidence, &recording, &subject).into_iter().try_for_each(output::line)?;
    let (lines, agrees) = compared::agreement(&recording, &inputs, &found, &subject);
    lines.into_iter().try_for_each(output::line)?;
    let lacks = compared::proof(&evidence, &name_of(file));
    output::say(&messages::text(&lacks, format));
    Ok(if agrees && !lacks.has_errors() { Exit::Done } else { Exit::Different })
}

/// Whether a path means standard input or output.
pub fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}
