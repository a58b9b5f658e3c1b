//! `axgen tune`: proposes stages from recordings of an axis, as a report or as JSON.

use crate::arguments::{DriveArguments, SetArguments, TuneArguments};
use crate::exit::Exit;
use crate::input;
use crate::measure::{Reading, Recordings, say, verdicts_json};
use crate::messages::{self, Format};
use crate::one_file::{self, Rule};
use crate::output;
use generator::axis::{Filter, Mode, Stage};
use generator::codes;
use generator::config;
use generator::diagnostics::Slashes;
use generator::parameters::words::Words;
use golden::measure::{Measured, Record, Verdict};
use golden::svg;
use golden::tune::{self, Prefer, Proposal, Stages, Tuning, signals, text};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Runs the command.
pub fn run(of: &TuneArguments, format: Format) -> Result<Exit, Exit> {
    let arguments = &of.subject.set;
    let drive = DriveArguments { response: of.response.clone(), ..DriveArguments::default() };
    let is_picture = |found: &[u8]| found.starts_with(svg::HEAD.as_bytes());
    let rules = [Rule::by_force(of.force), Rule::earlier_output(of.force, &is_picture)];
    allowed(arguments, of, rules)?;
    let is_set = of.stage == ["set"];
    let given = if is_set { Vec::new() } else { config::stage_keys(&of.stage).map_err(Exit::Input)? };
    let set = input::read_to_tune(arguments, [drive.keys(), given].concat(), format)?;
    let designed = input::axis(&set, of.subject.axis.as_deref())?;
    let cycle_time = Some(designed.axis.cycle_time());
    let reading = Reading { map: &of.map, cycle_time, excitation: of.excitation };
    let all = Recordings::read(&of.recording, of.excited.as_deref(), &reading)?;
    let prefer = if of.response.is_some() { Prefer::Set } else { Prefer::Excited };
    let stages = if of.stage.is_empty() { Stages::Proposed } else { Stages::Given };
    let mut tuning = tune::tune(designed, &all.own.1, all.second(), prefer, stages);
    let name = &designed.axis.name;
    let chosen = chosen(&mut tuning, of.apply.as_deref());
    let has_files = of.signals.is_some() || of.picture.is_some();
    let with = chosen.as_ref().filter(|_| has_files).and_then(|chosen| {
        let record = all.own.1.record.as_ref()?;
        signals::with_stages(&tuning, record, &chosen.stages)
    });
    let is_missing = has_files && with.is_none();
    if is_missing && chosen.is_some() {
        let found = "the response of the drive is not known: no signals can be predicted";
        let instead = "measure it: --excited FILE, --response FILE, or drive.response of the set";
        tuning.verdicts.push(Verdict::refusal(codes::NOT_PREDICTED, found, instead));
    }
    if of.json {
        output::line(format!("{:#}", as_json(name, &tuning, &all)))?;
    } else {
        output::print(text::report(&tuning, name))?;
        let mut report = all.said();
        say(&mut report, format!("axis {name}"), &tuning.verdicts);
        output::say(&messages::text(&report, format));
    }
    let Some(chosen) = chosen.filter(|_| !is_missing) else { return Ok(Exit::Different) };
    if let Some(with) = &with {
        draw(&all.own.1, with, &setup(name, &tuning, &chosen), of, rules)?;
    }
    if of.apply.is_some() {
        apply(arguments, format, name, &chosen, of.json)?;
    }
    Ok(Exit::Done)
}

/// Says beforehand what would not be written.
fn allowed(arguments: &SetArguments, of: &TuneArguments, rules: [Rule<'_>; 2]) -> Result<(), Exit> {
    let outs: Vec<&Path> = of.signals.iter().chain(&of.picture).map(PathBuf::as_path).collect();
    one_file::told_apart(&outs)?;
    for (out, rule) in [of.signals.as_deref(), of.picture.as_deref()].into_iter().zip(rules) {
        let Some(out) = out else { continue };
        let inputs = [Some(arguments.set.as_path()), Some(&of.recording), of.excited.as_deref()];
        one_file::kept_apart(out, inputs.into_iter().flatten())?;
        rule.allows(out)?;
    }
    Ok(())
}

/// The proposal of a name, else the first one; `None` after a message.
fn chosen(tuning: &mut Tuning, kind: Option<&str>) -> Option<Proposal> {
    let is_it = |of: &&Proposal| kind.is_none_or(|kind| of.kind.word() == kind);
    let found = tuning.proposals.iter().find(is_it).cloned();
    if let (None, Some(kind), false) = (&found, kind, tuning.proposals.is_empty()) {
        let all: Vec<&str> = tuning.proposals.iter().map(|of| of.kind.word()).collect();
        let found = format!("there is no proposal {kind}; there are: {}", all.join(", "));
        let instead = "one of these; `first` is for a drive whose response is not known";
        tuning.verdicts.push(Verdict::refusal(codes::NO_PROPOSAL, found, instead));
    }
    found
}

/// The lines above a picture.
fn setup(axis: &str, tuning: &Tuning, of: &Proposal) -> Vec<String> {
    let report = text::report(&Tuning { proposals: vec![of.clone()], ..tuning.clone() }, axis);
    report.lines().map(|line| line.trim_start().to_owned()).collect()
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
    let picture = of.picture.as_deref().zip(signals::svg(moves, with, setup.to_vec()));
    let picture = picture.map(|(path, picture)| one_file::stage(path, picture.as_bytes(), of_picture));
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
    let count = input::counted(of.stages.len(), "stage");
    let head = format!("{}: {} of {}, enable DRYRUN", path.slashes(), count, of.kind.word());
    let lines: Vec<String> = std::iter::once(head).chain(applied.changes).collect();
    if is_json {
        output::say(&(lines.join("\n") + "\n"));
        return Ok(());
    }
    lines.into_iter().try_for_each(output::line)
}

fn as_json(axis: &str, tuning: &Tuning, all: &Recordings<'_>) -> Value {
    let each = || all.all().flat_map(|(_, measured)| &measured.verdicts).chain(&tuning.verdicts);
    let of = |refuses: bool| verdicts_json(each().filter(move |verdict: &&Verdict| verdict.refuses == refuses));
    json!({
        "axis": axis,
        "proposals": tuning.proposals.iter().map(|proposal| proposal_json(tuning, proposal)).collect::<Vec<_>>(),
        "refused": of(true),
        "notes": of(false),
    })
}

fn proposal_json(tuning: &Tuning, proposal: &Proposal) -> Value {
    let predicted = proposal.predicted.as_ref();
    let residuals = predicted.iter().flat_map(|of| tuning.chosen.iter().zip(&of.left.residuals));
    let residuals = residuals.map(|(chosen, left)| json!({ "hz": chosen.hz, "ratio": left }));
    json!({
        "kind": proposal.kind.word(),
        "stages": proposal.stages.iter().enumerate().map(stage_json).collect::<Vec<_>>(),
        "residuals": residuals.collect::<Vec<_>>(),
        "ring_down": predicted.and_then(|of| of.left.ring),
        "following_error_ratio": predicted.and_then(|of| of.effect.following_error),
        "peak_v_add": predicted.map(|of| of.effect.peak_v_add),
        "ms": predicted.map(|of| of.ms[0]),
        "ms_half_cycle": predicted.map(|of| of.ms[1]),
        "ms_load": predicted.map(|of| &of.ms[2..]),
        "hardly_useful": predicted.map(|_| proposal.is_useless()),
    })
}

fn stage_json((index, stage): (usize, &Stage)) -> Value {
    let (direct_source, damping) = match stage.mode {
        Mode::Direct { source } => (Some(source.name()), None),
        Mode::Indirect { osc_damping } | Mode::SetPoint { osc_damping } => (None, Some(osc_damping)),
    };
    let bandpass = stage.filter.iter().find_map(|filter| match filter {
        Filter::Bandpass { prototype, order, f0, q_factor } => Some((prototype.name(), *order, *f0, *q_factor)),
        Filter::NoFilter | Filter::Allpass { .. } => None,
    });
    let allpass = stage.filter.iter().find_map(|filter| match filter {
        Filter::Allpass { f0, q_factor } => Some(json!({ "f0": f0, "q": q_factor })),
        Filter::NoFilter | Filter::Bandpass { .. } => None,
    });
    json!({
        "stage": index,
        "mode": stage.mode.word(),
        "direct_source": direct_source,
        "f0": bandpass.map(|of| of.2),
        "q": bandpass.map(|of| of.3),
        "damping": damping,
        "weight": stage.weight(),
        "prototype": bandpass.map(|of| of.0),
        "order": bandpass.map(|of| of.1),
        "allpass": allpass,
    })
}
