//! `axgen run`: one block, one engine, samples from a CSV file to a CSV file, or compared with a recording.

use crate::arguments::SetArguments;
use crate::exit::Exit;
use crate::input::{self, counted};
use crate::messages::Format;
use crate::one_file;
use crate::output;
use generator::blocks::Designed;
use generator::blocks::{self, Block};
use generator::codes;
use generator::diagnostics::{Diagnostic, Place, Report};
use golden::case::named_block;
use golden::compare::{self, Difference, compare};
use golden::csv::{self, Reals, Recording};
use golden::engine::{self, ENGINES, Engine};
use golden::samples::{Samples, Shape};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// What the command takes, beside the set.
pub struct Request {
    /// the axis; none: the only one
    pub axis: Option<String>,
    /// the block
    pub block: String,
    /// the engine
    pub engine: String,
    /// where the inputs are; none: in `compare`
    pub stimulus: Option<PathBuf>,
    /// a recording of the outputs
    pub compare: Option<PathBuf>,
    /// where the outputs go; none: nowhere if they are compared, else standard output
    pub out: Option<PathBuf>,
    /// reals as the digits of their bits
    pub hex: bool,
}

/// Runs the command.
pub fn run(arguments: &SetArguments, format: Format, request: &Request) -> Result<Exit, Exit> {
    let (set, _) = input::read(arguments, format)?;
    let designed = input::axis(&set, request.axis.as_deref())?;
    let block = block_of(designed, &request.block)?;
    let engine = named_engine(&request.engine)?;
    let out = request.out.as_deref().filter(|out| !is_standard(out));
    if let Some(out) = out {
        let inputs = [Some(arguments.set.as_path()), request.stimulus.as_deref(), request.compare.as_deref()];
        one_file::kept_apart(out, inputs.into_iter().flatten())?;
    }
    let shape = |variables| Shape::of(variables, designed.axis.real);
    let (inputs, outputs) = (shape(&block.program.inputs), shape(&block.program.outputs));
    let recording = request.compare.as_deref().map(|file| {
        // Beside a stimulus the recording has only outputs.
        let of =
            if request.stimulus.is_some() { &Shape { real: designed.axis.real, signals: Vec::new() } } else { &inputs };
        csv::read_recording(&read(file)?, of, &outputs).map_err(|mistakes| wrong(file, &mistakes))
    });
    let recording = recording.transpose()?;
    let inputs = match (request.stimulus.as_deref(), &recording) {
        (Some(file), _) => csv::read(&read(file)?, &inputs).map_err(|mistakes| wrong(file, &mistakes))?,
        (None, Some(recording)) => recording.inputs.clone(),
        (None, None) => {
            let found = "which inputs? give --stimulus or --compare with a CSV file";
            return Err(Exit::input(codes::USAGE, "--stimulus", found));
        }
    };
    let found = engine::run(engine, designed, &block, &inputs)
        .map_err(|failure| Exit::environment(codes::NO_ENGINE, format!("engine {engine}"), failure))?;
    let text = || csv::write(&[&found], if request.hex { Reals::Hexadecimal } else { Reals::Decimal });
    match out {
        Some(out) => fs::write(out, text()).map_err(|error| Exit::unwritable(out.display(), error))?,
        None if recording.is_none() || request.out.is_some() => output::print(text())?,
        None => {}
    }
    recording.map_or(Ok(Exit::Done), |recording| compared(&recording, &found, engine))
}

/// Says how a recording differs from what an engine gives.
fn compared(recording: &Recording, found: &Samples, engine: Engine) -> Result<Exit, Exit> {
    let names: Vec<&str> = recording.outputs.shape.signals.iter().map(|signal| signal.name.as_str()).collect();
    let Difference { bits, first } = compare(&found.only(&recording.recorded), &recording.outputs);
    let samples = counted(recording.outputs.len(), "sample");
    let bits_said = counted(bits, "differing bit");
    output::line(format!("{} against engine {engine}, {samples}: {bits_said}", names.join(", ")))?;
    let Some(compare::FirstDifference { sample, signal, expected, found }) = first else {
        // Runs of different length differ, though no sample of both does.
        return Ok(if bits == 0 { Exit::Done } else { Exit::Different });
    };
    let [recorded, computed] = [found, expected].map(|value| {
        let mut texts = [String::new(), String::new()];
        csv::cell(value, Reals::Decimal, &mut texts[0]);
        csv::cell(value, Reals::Hexadecimal, &mut texts[1]);
        if texts[0] == texts[1] { texts[0].clone() } else { texts.join(" = ") }
    });
    let place = format!("sample {sample} (line {}), {signal}", sample + 2);
    output::line(format!("first: {place}: {recorded} recorded, {computed} computed"))?;
    Ok(Exit::Different)
}

/// The mistakes of a CSV file.
fn wrong(file: &Path, mistakes: &[csv::Mistake]) -> Exit {
    let whole = Place::whole(name_of(file));
    let mut report = Report::default();
    for csv::Mistake { line, column, found, allowed } in mistakes {
        let place = Place { line: *line, column: *column, ..whole.clone() };
        report.push(Diagnostic::error(codes::SAMPLES, place, found).allowed(allowed));
    }
    Exit::Input(report.shortened())
}

/// The block of that name.
fn block_of(designed: &Designed, name: &str) -> Result<Block, Exit> {
    let names = blocks::names(&designed.axis);
    if !names.contains(&name) {
        return Err(Exit::no_such("--block", "block", name, &names));
    }
    Ok(named_block(designed, name).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}")))
}

fn named_engine(name: &str) -> Result<Engine, Exit> {
    let names = ENGINES.map(|engine| engine.to_string());
    let found = ENGINES.into_iter().find(|engine| engine.to_string() == name);
    found.ok_or_else(|| Exit::no_such("--engine", "engine", name, &names.each_ref().map(String::as_str)))
}

fn read(path: &Path) -> Result<String, Exit> {
    let text = if is_standard(path) { io::read_to_string(io::stdin()) } else { fs::read_to_string(path) };
    text.map_err(|error| Exit::input(codes::UNREADABLE, name_of(path), format!("cannot be read: {error}")))
}

fn name_of(input: &Path) -> String {
    if is_standard(input) { "standard input".to_owned() } else { input.display().to_string() }
}

/// Whether a path stands for standard input or output.
fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}
