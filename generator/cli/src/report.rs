//! `axgen report`: all of the axes of a set as one page of HTML, to print and to archive.

use crate::arguments::ReportArguments;
use crate::exit::Exit;
use crate::input;
use crate::measure;
use crate::messages::Format;
use crate::one_file::{self, Rule};
use commands::measure::{Reading, Recordings};
use commands::report::{self, Request};
use commands::{generate, verify};
use generator::config;
use generator::pipeline::{self, Set};
use golden::engine::Engine;

/// Runs the command.
pub fn run(of: &ReportArguments, format: Format) -> Result<Exit, Exit> {
    let engines = engines(&of.engines)?;
    let path = of.set.set.as_path();
    let is_report = |found: &[u8]| found.starts_with(report::HEAD.as_bytes());
    let (out, rule) = (of.out.as_deref(), Rule::earlier_output(of.force, &is_report));
    let inputs = [Some(path), of.recording.as_deref(), of.excited.as_deref()];
    one_file::kept_apart(out, inputs.into_iter().flatten())?;
    let options = of.set.list.options(of.drive.keys(None));
    let (set, messages) = pipeline::read_to_look_at(path, &options, &config::load);
    let set = input::said(set, &messages, format)?;
    for name in &of.axes {
        commands::axis(&set, Some(name))?;
    }
    let targets = generate::targets(&of.targets, &set.targets, [])?;
    let recordings = recordings(of, &set)?;
    let request = Request {
        source: (path, &options, &config::load),
        targets: &targets,
        engines: &engines,
        samples: of.samples,
        recordings: recordings.as_ref(),
    };
    let page = report::html(&request, &set, &messages, &of.axes)?;
    one_file::write(out, page.as_bytes(), rule)?;
    Ok(Exit::Done)
}

/// The engines of these names; all that need no compiler, if there is none: the page is the same on every computer.
fn engines(names: &[String]) -> Result<Vec<Engine>, Exit> {
    let mut engines = verify::engines(names)?;
    engines.retain(|engine| !names.is_empty() || !engine.is_compiled());
    Ok(engines)
}

/// The recordings of the only axis.
fn recordings(of: &ReportArguments, set: &Set) -> Result<Option<Recordings>, Exit> {
    let Some(recording) = of.recording.as_deref() else { return Ok(None) };
    let name = if let [name] = of.axes.as_slice() { Some(name.as_str()) } else { None };
    let cycle_time = Some(commands::axis(set, name)?.axis.cycle_time());
    let reading = Reading { map: &of.map, cycle_time, excitation: of.excitation };
    measure::read(recording, of.excited.as_deref(), &reading).map(Some)
}
