//! `axgen tune`: stages that recordings of an axis ask for, as a report or as JSON.

use crate::arguments::{DriveArguments, SetArguments, Tuned};
use crate::exit::Exit;
use crate::input;
use crate::measure::{Reading, Recordings, say, verdicts_json};
use crate::messages::{self, Format};
use crate::output;
use generator::axis::{Filter, Mode, Stage};
use generator::config;
use generator::parameters::words::Words;
use golden::measure::Verdict;
use golden::tune::{self, Prefer, Proposal, Stages, Tuning, text};
use serde_json::{Value, json};

/// Runs the command.
pub fn run(arguments: &SetArguments, format: Format, axis: Option<&str>, of: &Tuned) -> Result<Exit, Exit> {
    let drive = DriveArguments { response: of.response.clone(), ..DriveArguments::default() };
    let is_set = of.stage == ["set"];
    let given = if is_set { Vec::new() } else { config::stage_keys(&of.stage).map_err(Exit::Input)? };
    let set = input::read_to_tune(arguments, [drive.keys(), given].concat(), format)?;
    let designed = input::axis(&set, axis)?;
    let cycle_time = Some(designed.axis.cycle_time());
    let reading = Reading { map: &of.map, cycle_time, excitation: of.excitation };
    let all = Recordings::read(&of.recording, of.excited.as_deref(), &reading)?;
    let prefer = if of.response.is_some() { Prefer::Set } else { Prefer::Excited };
    let stages = if of.stage.is_empty() { Stages::Proposed } else { Stages::Given };
    let tuning = tune::tune(designed, &all.own.1, all.second(), prefer, stages);
    let name = &designed.axis.name;
    if of.json {
        output::line(format!("{:#}", as_json(name, &tuning, &all)))?;
    } else {
        output::print(text::report(&tuning, name))?;
        let mut report = all.said();
        say(&mut report, format!("axis {name}"), &tuning.verdicts);
        output::say(&messages::text(&report, format));
    }
    Ok(if tuning.proposals.is_empty() { Exit::Different } else { Exit::Done })
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
    let residuals = predicted.iter().flat_map(|of| tuning.chosen.iter().zip(&of.residuals));
    let residuals = residuals.map(|(chosen, left)| json!({ "hz": chosen.hz, "ratio": left }));
    json!({
        "kind": proposal.kind.word(),
        "stages": proposal.stages.iter().enumerate().map(stage_json).collect::<Vec<_>>(),
        "residuals": residuals.collect::<Vec<_>>(),
        "ring_down": predicted.and_then(|of| of.ring_down),
        "following_error_ratio": predicted.and_then(|of| of.following_error),
        "peak_v_add": predicted.map(|of| of.peak_v_add),
        "ms": predicted.map(|of| of.ms[0]),
        "ms_half_cycle": predicted.map(|of| of.ms[1]),
        "ms_load": predicted.map(|of| &of.ms[2..]),
        "hardly_useful": predicted.map(|of| of.is_useless),
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
