//! The files of samples for `axgen run`: a stimulus, a recording, or both.

use crate::arguments::RunArguments;
use crate::exit::Exit;
use crate::messages::Format;
use crate::run::is_standard;
use crate::scenario;
use commands::samples::checked;
use generator::blocks::{Block, Designed};
use generator::codes;
use generator::config::{self, LARGEST_SAMPLES, Unreadable};
use generator::diagnostics::Slashes;
use golden::recording::{self, Recording};
use golden::samples::{Samples, Shape};
use golden::signals;
use golden::table::Table;
use std::io;
use std::path::Path;

/// The inputs of a run, and the recording to compare with.
pub struct Given {
    pub inputs: Samples,
    /// the inputs that a file contains, by their positions; the others keep their start values
    pub given: Vec<usize>,
    pub recording: Option<Recording>,
}

/// Reads the files that the request names.
pub fn read(request: &RunArguments, designed: &Designed, block: &Block, format: Format) -> Result<Given, Exit> {
    let shape = |variables| Shape::of(variables, block.program.real);
    let (inputs, outputs) = (shape(&block.program.inputs), shape(&block.program.outputs));
    let cycle = designed.axis.cycle_time_ns;
    let [stimulus, compare] = [&request.stimulus, &request.compare].map(|file| file.as_deref());
    let wanted: Vec<&str> = request.map.iter().map(|(name, _)| name.as_str()).collect();
    let [of_stimulus, of_recording] = [stimulus, compare].map(|file| file.map(text).transpose());
    let texts = [of_stimulus?, of_recording?];
    let tables =
        texts.each_ref().map(|text| text.as_deref().map(|text| Table::read(text, &wanted).without(&request.map)));
    let read: Vec<&Table<'_>> = tables.iter().flatten().collect();
    let unknown = signals::unknown(&request.map, &read);
    if read.is_empty() && !request.map.is_empty() {
        let found = "names columns of a CSV file: give --stimulus or --compare with it";
        return Err(Exit::input(codes::USAGE, "--map", found));
    }
    let is_alone = request.stimulus.is_none() && request.scenario.is_none();
    let recording = tables[1].as_ref().zip(compare).map(|(table, file)| {
        let recording = recording::read(table, [&inputs, &outputs], is_alone, &request.map, cycle);
        checked(recording, &unknown, &name_of(file))
    });
    let recording = recording.transpose()?;
    let (inputs, given) = match (tables[0].as_ref().zip(stimulus), request.scenario.as_deref(), &recording) {
        (Some((table, file)), ..) => {
            checked(recording::stimulus(table, [&inputs, &outputs], &request.map, cycle), &unknown, &name_of(file))?
        }
        (None, Some(program), _) => {
            let options = scenario::options(&request.moved_by);
            let scenario = scenario::made(program, designed, block, &options, format)?;
            (scenario.inputs, (0..inputs.signals.len()).collect())
        }
        (None, None, Some(recording)) => (recording.inputs.clone(), recording.given.clone()),
        (None, None, None) => {
            let found = "which inputs? give --stimulus or --compare with a CSV file, or --scenario";
            return Err(Exit::input(codes::USAGE, "--stimulus", found));
        }
    };
    Ok(Given { inputs, given, recording })
}

/// The text of a file of samples.
pub fn text(path: &Path) -> Result<String, Exit> {
    let bytes = match is_standard(path) {
        true => config::load_from(io::stdin(), Vec::new(), LARGEST_SAMPLES),
        false => config::load_up_to(path, LARGEST_SAMPLES),
    };
    bytes.map(config::characters).map_err(|unreadable| {
        let said = unreadable.diagnostic(name_of(path));
        Exit::Input(match unreadable {
            Unreadable::TooLarge => said.allowed(format!("{} MiB", LARGEST_SAMPLES >> 20)).into(),
            Unreadable::System(_) => said.into(),
        })
    })
}

/// Its name in messages.
pub fn name_of(input: &Path) -> String {
    if is_standard(input) { "standard input".to_owned() } else { input.slashes() }
}
