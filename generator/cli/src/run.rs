//! `axgen run`: one block, one engine, samples from a CSV file to a CSV file, or compared with a recording.

use crate::arguments::SetArguments;
use crate::exit::Exit;
use crate::input::{self, counted};
use golden::case::named_block;
use golden::compare::{Difference, Place, compare};
use golden::csv::{self, Reals, Recording};
use golden::engine::{self, ENGINES, Engine, Failure};
use golden::samples::{Samples, Shape};
use std::io::{Read, Write};
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
pub fn run(arguments: &SetArguments, request: &Request) -> Result<Exit, Exit> {
    let (set, _) = input::read(arguments)?;
    let axis = input::axis(&set, request.axis.as_deref())?;
    let block = named_block(axis, &request.block).map_err(Exit::input)?;
    let engine = named_engine(&request.engine)?;
    let shape = |variables| Shape::of(variables, axis.real);
    let (inputs, outputs) = (shape(&block.program.inputs), shape(&block.program.outputs));
    let recording = request.compare.as_deref().map(|file| {
        // Beside a stimulus the recording has only outputs.
        let of = if request.stimulus.is_some() { &Shape { real: axis.real, signals: Vec::new() } } else { &inputs };
        csv::read_recording(&read(file)?, of, &outputs).map_err(|mistakes| wrong(file, &mistakes))
    });
    let recording = recording.transpose()?;
    let inputs = match (request.stimulus.as_deref(), &recording) {
        (Some(file), _) => csv::read(&read(file)?, &inputs).map_err(|mistakes| wrong(file, &mistakes))?,
        (None, Some(recording)) => recording.inputs.clone(),
        (None, None) => return Err(Exit::input("which inputs? give --stimulus or --compare with a CSV file")),
    };
    let found = engine::run(engine, axis, &block, &inputs).map_err(|failure| match failure {
        Failure::Environment(text) => Exit::environment(text),
        failure => Exit::environment(format!("engine {engine}: {failure}")),
    })?;
    let out = request.out.as_deref().or(recording.is_none().then_some(Path::new("-")));
    if let Some(out) = out {
        write(out, &csv::write(&[&found], if request.hex { Reals::Hexadecimal } else { Reals::Decimal }))?;
    }
    Ok(recording.map_or(Exit::Done, |recording| compared(&recording, &found, engine)))
}

/// Says how a recording differs from what an engine gives.
#[expect(clippy::print_stdout, reason = "what the command has found")]
fn compared(recording: &Recording, found: &Samples, engine: Engine) -> Exit {
    let names: Vec<&str> = recording.outputs.shape.signals.iter().map(|signal| signal.name.as_str()).collect();
    let Difference { bits, first } = compare(&found.only(&recording.recorded), &recording.outputs);
    let samples = counted(recording.outputs.len(), "sample");
    println!("{} against engine {engine}, {samples}: {}", names.join(", "), counted(bits, "differing bit"));
    let Some(Place { sample, signal, expected, found }) = first else {
        // Runs of different length differ, though no sample of both does.
        return if bits == 0 { Exit::Done } else { Exit::Different };
    };
    let [recorded, computed] = [found, expected].map(|value| {
        let mut texts = [String::new(), String::new()];
        csv::cell(value, Reals::Decimal, &mut texts[0]);
        csv::cell(value, Reals::Hexadecimal, &mut texts[1]);
        if texts[0] == texts[1] { texts[0].clone() } else { texts.join(" = ") }
    });
    println!("first: sample {sample} (line {}), {signal}: {recorded} recorded, {computed} computed", sample + 2);
    Exit::Different
}

/// The mistakes of a CSV file.
fn wrong(file: &Path, mistakes: &[csv::Mistake]) -> Exit {
    let line = |mistake: &csv::Mistake| {
        let csv::Mistake { line, column, found, allowed } = mistake;
        format!("{}:{line}:{column}: {found}; allowed: {allowed}\n", file.display())
    };
    Exit::input(mistakes.iter().map(line).collect::<String>())
}

fn named_engine(name: &str) -> Result<Engine, Exit> {
    let names = || ENGINES.map(|engine| engine.to_string()).join(", ");
    ENGINES
        .into_iter()
        .find(|engine| engine.to_string() == name)
        .ok_or_else(|| Exit::input(format!("no engine `{}`; there is: {}", name.escape_default(), names())))
}

fn read(path: &Path) -> Result<String, Exit> {
    if path.as_os_str() == "-" {
        let mut text = String::new();
        let read = std::io::stdin().read_to_string(&mut text);
        return read.map(|_| text).map_err(|error| Exit::input(format!("standard input: {error}")));
    }
    std::fs::read_to_string(path).map_err(|error| Exit::input(format!("{}: {error}", path.display())))
}

fn write(path: &Path, text: &str) -> Result<(), Exit> {
    let written =
        if path.as_os_str() == "-" { std::io::stdout().write_all(text.as_bytes()) } else { std::fs::write(path, text) };
    written.map_err(|error| Exit::environment(format!("{}: {error}", path.display())))
}
