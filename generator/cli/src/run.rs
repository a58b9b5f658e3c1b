//! `axgen run`: one block, one engine, samples from a CSV file to a CSV file, or compared with a recording.

use crate::arguments::SetArguments;
use crate::exit::Exit;
use crate::input::{self, counted};
use crate::messages::Format;
use crate::one_file::{self, Rule};
use crate::output;
use crate::scenario;
use generator::blocks::Designed;
use generator::blocks::{self, Block};
use generator::codes;
use generator::config::{self, LARGEST_SAMPLES, Unreadable};
use generator::diagnostics::{Diagnostic, Place, Report, Slashes};
use golden::case::named_block;
use golden::compare::{self, Difference, compare};
use golden::csv::{self, Reals};
use golden::engine::{self, ENGINES, Engine};
use golden::recording::{self, Recording};
use golden::samples::{Samples, Shape};
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
    /// where the inputs are; none: in `compare`, or in the scenario
    pub stimulus: Option<PathBuf>,
    /// the NC program that makes the inputs
    pub scenario: Option<PathBuf>,
    /// how that program is run
    pub options: golden::scenario::Options,
    /// a recording of the outputs
    pub compare: Option<PathBuf>,
    /// which column of the recording is which signal, where the names do not say it
    pub map: Vec<(String, String)>,
    /// where the outputs go; none: nowhere if they are compared, else standard output
    pub out: Option<PathBuf>,
    /// whether any file there may be replaced, not only an earlier output
    pub force: bool,
    /// reals as the digits of their bits
    pub hex: bool,
}

/// A column and its signal.
pub fn mapping(text: &str) -> Result<(String, String), &'static str> {
    let (column, signal) = text.rsplit_once('=').ok_or("SCOPE=SIGNAL is allowed: MAIN.x.v_add=v_add")?;
    Ok((column.to_owned(), signal.to_owned()))
}

/// Runs the command.
pub fn run(arguments: &SetArguments, format: Format, request: &Request) -> Result<Exit, Exit> {
    let (set, _) = input::read(arguments, format)?;
    let designed = input::axis(&set, request.axis.as_deref())?;
    let block = block_of(designed, &request.block)?;
    let engine = engine_named(&request.engine)?;
    let out = request.out.as_deref().filter(|out| !is_standard(out));
    let shape = |variables| Shape::of(variables, designed.axis.real);
    let (inputs, outputs) = (shape(&block.program.inputs), shape(&block.program.outputs));
    // An earlier output has the same first line.
    let head = csv::write(&[&Samples::with_capacity(outputs.clone(), 0)], Reals::Decimal);
    let is_output = |found: &[u8]| found.starts_with(head.as_bytes());
    let rule = Rule::own(request.force, &is_output);
    if let Some(out) = out {
        let Request { stimulus, scenario, compare, .. } = request;
        let inputs = [Some(arguments.set.as_path()), stimulus.as_deref(), scenario.as_deref(), compare.as_deref()];
        one_file::kept_apart(out, inputs.into_iter().flatten())?;
        rule.allows(out)?;
    }
    let recording = request.compare.as_deref().map(|file| {
        // Beside a stimulus the recording has only outputs.
        let has_inputs = request.stimulus.is_none() && request.scenario.is_none();
        let of = if !has_inputs { &Shape { real: designed.axis.real, signals: Vec::new() } } else { &inputs };
        recording::read(&read(file)?, [of, &outputs], &request.map, designed.axis.cycle_time_ns)
            .map_err(|mistakes| wrong(file, &mistakes))
    });
    let recording = recording.transpose()?;
    let inputs = match (request.stimulus.as_deref(), request.scenario.as_deref(), &recording) {
        (Some(file), ..) => csv::read(&read(file)?, &inputs).map_err(|mistakes| wrong(file, &mistakes))?,
        (None, Some(program), _) => scenario::made(program, designed, &block, &request.options, format)?.inputs,
        (None, None, Some(recording)) => recording.inputs.clone(),
        (None, None, None) => {
            let found = "which inputs? give --stimulus or --compare with a CSV file, or --scenario";
            return Err(Exit::input(codes::USAGE, "--stimulus", found));
        }
    };
    let found = engine::run(engine, designed, &block, &inputs)
        .map_err(|failure| Exit::environment(codes::NO_ENGINE, format!("engine {engine}"), failure))?;
    let text = || csv::write(&[&found], if request.hex { Reals::Hexadecimal } else { Reals::Decimal });
    match out {
        Some(out) => one_file::write(Some(out), text().as_bytes(), rule)?,
        None if recording.is_none() || request.out.is_some() => output::print(text())?,
        None => {}
    }
    let Some(recording) = recording else { return Ok(Exit::Done) };
    let moved = recording.moved_inputs();
    // What the rounding of the inputs changes is asked of the reference: every engine would say the same.
    let moved = moved.map(|moved| engine::run(Engine::Reference, designed, &block, &moved)).transpose();
    let moved = moved.unwrap_or_else(|failure| panic!("a defect of axgen: {failure}"));
    compared(&recording, &Computed { engine, outputs: found, moved }, designed, &block)
}

/// What an engine gives.
struct Computed {
    engine: Engine,
    outputs: Samples,
    /// for inputs that would have been recorded the same
    moved: Option<Samples>,
}

/// Says how a recording differs from what an engine gives.
fn compared(recording: &Recording, computed: &Computed, designed: &Designed, block: &Block) -> Result<Exit, Exit> {
    let names: Vec<&str> = recording.outputs.shape.signals.iter().map(|signal| signal.name.as_str()).collect();
    let outputs = computed.outputs.only(&recording.recorded);
    let moved = computed.moved.as_ref().map(|moved| moved.only(&recording.recorded));
    let Difference { bits, first } = compare(&outputs, &recording.outputs);
    let samples = counted(recording.outputs.len(), "sample");
    let bits_said = counted(bits, "differing bit");
    output::line(format!("{} against engine {}, {samples}: {bits_said}", names.join(", "), computed.engine))?;
    if !recording.left_out.is_empty() {
        output::line(format!("left out, no signal of {}: {}", block.program.block, recording.left_out.join(", ")))?;
    }
    let errors = recording.errors(&outputs, moved.as_ref());
    let is_explained = errors.iter().all(|error| error.is_explained) && outputs.len() == recording.outputs.len();
    if let Some(first) = first.filter(|_| !is_explained) {
        first_difference(&first, recording)?;
    }
    for ((error, name), (position, precision)) in
        errors.iter().zip(&names).zip(recording.recorded.iter().zip(&recording.output_precision))
    {
        if error.largest > 0.0 && error.largest.is_finite() {
            let recording::Error { largest, sample, is_explained } = *error;
            let unit = unit(block.program.outputs[*position].doc, designed);
            let line = recording.lines.get(sample).copied().unwrap_or_default();
            let verdict = match (precision.digits, is_explained) {
                (0, true) => "; the digits recorded of the inputs explain it".to_owned(),
                (0, false) => String::new(),
                (digits, true) => format!("; agrees within the {} recorded", counted(digits, "digit")),
                (digits, false) => format!("; more than the {} recorded explain", counted(digits, "digit")),
            };
            output::line(format!(
                "{name}: largest error {largest:.2e}{unit} at sample {sample} (line {line}){verdict}"
            ))?;
        }
    }
    Ok(if is_explained { Exit::Done } else { Exit::Different })
}

fn first_difference(first: &compare::FirstDifference, recording: &Recording) -> Result<(), Exit> {
    let compare::FirstDifference { sample, signal, expected, found } = first;
    let [recorded, computed] = [found, expected].map(|value| {
        let mut texts = [String::new(), String::new()];
        csv::cell(*value, Reals::Decimal, &mut texts[0]);
        csv::cell(*value, Reals::Hexadecimal, &mut texts[1]);
        if texts[0] == texts[1] { texts[0].clone() } else { texts.join(" = ") }
    });
    let line = recording.lines.get(*sample).copied().unwrap_or_default();
    output::line(format!("first: sample {sample} (line {line}), {signal}: {recorded} recorded, {computed} computed"))
}

/// The unit in a signal's comment, of this axis: ` um/s` of `[um/s or 0.001 deg/s]`.
fn unit(doc: &str, designed: &Designed) -> String {
    let Some((_, rest)) = doc.split_once('[') else { return String::new() };
    let unit = rest.split_once(']').map_or(rest, |(unit, _)| unit);
    let of_axis = match unit.split_once(" or ") {
        Some((_, rotary)) if designed.axis.control.is_rotary => rotary,
        Some((linear, _)) => linear,
        None => unit,
    };
    format!(" {of_axis}")
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
pub fn block_of(designed: &Designed, name: &str) -> Result<Block, Exit> {
    let names = blocks::names(&designed.axis);
    if !names.contains(&name) {
        return Err(Exit::no_such("--block", "block", name, &names));
    }
    Ok(named_block(designed, name).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}")))
}

/// The engine of that name.
pub fn engine_named(name: &str) -> Result<Engine, Exit> {
    let names = ENGINES.map(|engine| engine.to_string());
    let found = ENGINES.into_iter().find(|engine| engine.to_string() == name);
    found.ok_or_else(|| Exit::no_such("--engine", "engine", name, &names.each_ref().map(String::as_str)))
}

fn read(path: &Path) -> Result<String, Exit> {
    let bytes = match is_standard(path) {
        true => config::load_from(io::stdin(), Vec::new(), LARGEST_SAMPLES),
        false => config::load_up_to(path, LARGEST_SAMPLES),
    };
    let text =
        bytes.and_then(|bytes| String::from_utf8(bytes).map_err(|_| Unreadable::System("it is not UTF-8".to_owned())));
    text.map_err(|unreadable| {
        let (code, found) = unreadable.said();
        let said = Diagnostic::error(code, Place::whole(name_of(path)), found);
        Exit::Input(match unreadable {
            Unreadable::TooLarge => said.allowed(format!("{} MiB", LARGEST_SAMPLES >> 20)).into(),
            Unreadable::System(_) => said.into(),
        })
    })
}

fn name_of(input: &Path) -> String {
    if is_standard(input) { "standard input".to_owned() } else { input.slashes() }
}

/// Whether a path stands for standard input or output.
fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}
