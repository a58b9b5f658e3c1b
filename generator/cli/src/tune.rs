//! `axgen tune`: proposes stages from recordings of an axis, as a report or as JSON.

use crate::arguments::{DriveArguments, SetArguments, TuneArguments};
use crate::exit::Exit;
use crate::input;
use crate::measure::{Reading, Recordings, say, verdicts_json};
use crate::messages::{self, Format};
use crate::output;
use golden::measure::Verdict;
use golden::tune::{self, Prefer, Proposal, Stage, Tuning, text};
use serde_json::{Value, json};

/// Runs the command.
pub fn run(arguments: &SetArguments, format: Format, axis: Option<&str>, of: &TuneArguments) -> Result<Exit, Exit> {
    let drive = DriveArguments { response: of.response.clone(), ..DriveArguments::default() };
    let set = input::read_to_tune(arguments, drive.keys(), format)?;
    let designed = input::axis(&set, axis)?;
    let cycle_time = Some(designed.axis.cycle_time());
    let reading = Reading { map: &of.map, cycle_time, excitation: of.excitation };
    let all = Recordings::read(&of.recording, of.excited.as_deref(), &reading)?;
    let prefer = if of.response.is_some() { Prefer::Set } else { Prefer::Excited };
    let tuning = tune::tune(designed, &all.own.1, all.second(), prefer);
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
    let parameters = stage.parameters();
    json!({
        "stage": index,
        "mode": parameters.mode,
        "direct_source": parameters.direct_source,
        "f0": stage.shape.f0,
        "q": stage.shape.q,
        "damping": parameters.damping,
        "weight": stage.weight(),
        "prototype": parameters.prototype,
        "order": parameters.order,
        "allpass": stage.shape.allpass.map(|of| json!({ "f0": of.f0, "q": of.q })),
    })
}
