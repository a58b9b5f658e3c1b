//! `axgen tune`: proposes stages from recordings of an axis, as a report or as JSON.

use crate::arguments::{DriveArguments, SetArguments, TuneArguments};
use crate::exit::Exit;
use crate::input;
use crate::measure;
use crate::messages::{self, Format};
use crate::one_file::{self, Rule};
use crate::output;
use commands::json;
use commands::measure::{Reading, say};
use commands::tune::{chosen, proposals, setup};
use generator::codes;
use generator::config;
use generator::diagnostics::Slashes;
use golden::measure::{Measured, Record, Verdict};
use golden::tune::{self, Prefer, Proposal, Stages, Tuning, signals, text};
use std::collections::BTreeMap;

/// Runs the command.
pub fn run(of: &TuneArguments, format: Format) -> Result<Exit, Exit> {
    let arguments = &of.subject.set;
    let drive = DriveArguments { response: of.response.clone(), ..DriveArguments::default() };
    let rules = [Rule::by_force(of.force), Rule::earlier_picture(of.force)];
    let outs = [of.signals.as_deref(), of.picture.as_deref()].into_iter().zip(rules);
    let inputs = [Some(arguments.set.as_path()), Some(&of.recording), of.excited.as_deref()];
    one_file::allowed(outs, inputs.into_iter().flatten())?;
    let is_set = of.stage == ["set"];
    let given = if is_set { Vec::new() } else { config::stage_keys(&of.stage).map_err(Exit::Input)? };
    let set = input::read_to_tune(arguments, [drive.keys(of.subject.axis.as_deref()), given].concat(), format)?;
    let designed = commands::axis(&set, of.subject.axis.as_deref())?;
    let cycle_time = Some(designed.axis.cycle_time());
    let reading = Reading { map: &of.map, cycle_time, excitation: of.excitation };
    let all = measure::read(&of.recording, of.excited.as_deref(), &reading)?;
    let prefer = if of.response.is_some() { Prefer::Set } else { Prefer::Excited };
    let stages = if of.stage.is_empty() { Stages::Proposed } else { Stages::Given };
    let mut tuning = tune::tune(designed, &all.own.1, all.second(), prefer, stages);
    let name = &designed.axis.name;
    let chosen = chosen(&mut tuning, of.apply.as_deref());
    let has_files = of.signals.is_some() || of.picture.is_some();
    let asked = chosen.as_ref().filter(|_| has_files);
    let with = asked.and_then(|chosen| predicted(&mut tuning, &all.own.1, chosen));
    if of.json {
        output::line(json::text(&proposals(name, &tuning, &all)))?;
    } else {
        output::print(text::report(&tuning, name))?;
        let mut report = all.said();
        say(&mut report, format!("axis {name}"), &tuning.verdicts);
        output::say(&messages::text(&report, format));
    }
    let is_missing = has_files && with.is_none();
    let Some(chosen) = chosen.filter(|_| !is_missing) else { return Ok(Exit::Different) };
    if let Some(with) = &with {
        draw(&all.own.1, with, &setup(name, &tuning, &chosen), of, rules)?;
    }
    if of.apply.is_some() {
        apply(arguments, format, name, &chosen, of.json)?;
    }
    Ok(Exit::Done)
}

/// The moves as they would be with a proposal; `None` after a message.
fn predicted(tuning: &mut Tuning, moves: &Measured, of: &Proposal) -> Option<Record> {
    let with = moves.record.as_ref().and_then(|record| signals::with_stages(tuning, record, &of.stages));
    if with.is_none() {
        let found = "the response of the drive is not known: no signals can be predicted";
        let instead = "measure it: --excited FILE, --response FILE, or drive.response of the set";
        tuning.verdicts.push(Verdict::refusal(codes::NOT_PREDICTED, found, instead));
    }
    with
}

/// Writes the files that were asked for, all or none.
fn draw(
    moves: &Measured,
    with: &Record,
    setup: &[String],
    of: &TuneArguments,
    rules: [Rule<'_>; 2],
) -> Result<(), Exit> {
    let [of_signals, of_picture] = rules;
    let staged = of.signals.as_deref().map(|path| one_file::stage(path, signals::csv(with).as_bytes(), of_signals));
    let picture = of.picture.as_deref().zip(signals::picture(moves, with, setup.to_vec()));
    let picture = picture.map(|(path, picture)| one_file::stage(path, picture.svg().as_bytes(), of_picture));
    one_file::commit([staged.transpose()?, picture.transpose()?].into_iter().flatten())
}

/// Writes a proposal where the axis has its parameters, unless the file has changed meanwhile.
fn apply(arguments: &SetArguments, format: Format, axis: &str, of: &Proposal, is_json: bool) -> Result<(), Exit> {
    let options = arguments.list.options(Vec::new());
    let path = &arguments.set;
    let (applied, report) = generator::apply::stages(path, &options, axis, &of.stages, &config::load);
    let applied = input::said(applied, &report, format)?;
    let is_same = config::load(path).is_ok_and(|now| now == applied.before);
    if !is_same {
        return Err(Exit::input(codes::NOT_WRITTEN, path.slashes(), "has changed meanwhile; nothing was written"));
    }
    one_file::write(Some(path), &applied.after, Rule::by_force(true))?;
    let count = commands::words::counted(of.stages.len(), "stage");
    let head = format!("{}: {} of {}, enable DRYRUN", path.slashes(), count, of.kind.word());
    let lines: Vec<String> = std::iter::once(head).chain(applied.changes).collect();
    match (is_json, format) {
        (false, _) => lines.into_iter().try_for_each(output::line)?,
        (true, Format::Human) => output::say(&(lines.join("\n") + "\n")),
        (true, Format::Json) => output::say(&json::line(&BTreeMap::from([("applied", lines)]))),
    }
    Ok(())
}
