//! Recordings: what was measured, and the stages that are proposed from them.

use crate::request::Subject;
use crate::session::{Proposed, Session, load};
use commands::measure::{Reading, Recorded, Recordings, results};
use commands::refused;
use commands::tune::{chosen, proposals};
use generator::blocks::Designed;
use generator::config::characters;
use generator::diagnostics::Report;
use generator::{apply, codes, pipeline, response_file};
use golden::measure::text as measured_text;
use golden::table::Table;
use golden::tune::{self, Prefer, Stages, text};
use golden::{measure, tune::signals};
use serde_json::{Value, json};
use std::path::Path;

/// The recordings of a request.
fn read(session: &Session, names: [Option<&str>; 2], cycle_time: Option<f64>) -> Result<Recordings, Report> {
    let [own, excited] = names.map(|name| {
        let name = name.unwrap_or_default();
        let bytes = session.files.0.get(Path::new(name)).cloned();
        bytes.map(|bytes| Recorded { name: name.to_owned(), text: characters(bytes) })
    });
    let own = own.unwrap_or(Recorded { name: String::new(), text: String::new() });
    Recordings::read(own, excited, &Reading { map: &Vec::new(), cycle_time, excitation: None })
}

/// The probable use of a file, by its readers; `None`: its name says more than its content.
pub fn kind(bytes: &[u8]) -> Option<&'static str> {
    if response_file::is_response(bytes) {
        return Some("response");
    }
    let text = characters(bytes.to_vec());
    let channels = measure::read(&Table::read(&text, &[]), &[]).ok().filter(|channels| !channels.is_empty())?;
    let is_excited =
        |channel: &measure::Channel| channel.signal == "v_excite" && channel.values.iter().any(|v| *v != 0.0);
    Some(if channels.iter().any(is_excited) { "excited" } else { "recording" })
}

/// What a recording shows, in words, as data and as a picture.
pub fn measured(
    session: &Session,
    names: [Option<&str>; 2],
    cycle_time: Option<f64>,
) -> Result<(Value, Report), Report> {
    let all = read(session, names, cycle_time)?;
    let own = &all.own.1;
    let text: String = all.measured().map(measured_text::report).collect();
    let response = all.response().map(measured_text::response);
    let picture = measure::picture::of(own, all.response()).map(|picture| picture.svg());
    Ok((json!({ "results": results(&all), "text": text, "response": response, "picture": picture }), all.said()))
}

/// The proposals for an axis, and the spectra with the first one.
pub fn tuned(
    session: &mut Session,
    of: &Subject,
    axis: &str,
    names: [Option<&str>; 2],
) -> Result<(Value, Report), Report> {
    let (set, report) = pipeline::read_to_tune(of.path(), &of.options(), &load(&session.files));
    let Some(set) = set else { return Err(report) };
    let designed: &Designed = commands::axis(&set, Some(axis))?;
    let all = read(session, names, Some(designed.axis.cycle_time()))?;
    let prefer = if of.responses.iter().any(|response| response.axis == axis) { Prefer::Set } else { Prefer::Excited };
    let mut tuning = tune::tune(designed, &all.own.1, all.second(), prefer, Stages::Proposed);
    let first = chosen(&mut tuning, None);
    let picture = first.zip(all.own.1.record.as_ref()).and_then(|(first, record)| {
        let with = signals::with_stages(&tuning, record, &first.stages)?;
        let setup = commands::tune::setup(axis, &tuning, &first);
        Some(signals::picture(&all.own.1, &with, setup)?.svg())
    });
    let answer = json!({
        "proposals": proposals(axis, &tuning, &all),
        "text": text::report(&tuning, axis),
        "picture": picture,
    });
    let files = session.digests();
    session.tuning = Some(Proposed { of: of.clone(), axis: axis.to_owned(), files, tuning });
    Ok((answer, all.said()))
}

/// Writes a proposal of the last `tune` into the text of the user; returns the name of the file and the changes.
pub fn applied(session: &mut Session, of: &Subject, axis: &str, proposal: &str) -> Result<(Value, Report), Report> {
    let files = session.digests();
    let refused = |found: &str| refused::input(codes::USAGE, &of.set, format!("{found}: propose stages again"));
    let proposed =
        session.tuning.as_mut().ok_or_else(|| refused("the proposals are gone with the worker that made them"))?;
    if (&proposed.of, proposed.axis.as_str(), &proposed.files) != (of, axis, &files) {
        let found =
            format!("the proposals were made for the axis {} of {}, from other files", proposed.axis, proposed.of.set);
        return Err(refused(&found));
    }
    let chosen = chosen(&mut proposed.tuning, Some(proposal));
    let Some(chosen) = chosen else { return Err(refused(&format!("the proposal {proposal} does not exist"))) };
    let (applied, report) = apply::stages(of.path(), &of.options(), axis, &chosen.stages, &load(&session.files));
    let Some(applied) = applied else { return Err(report) };
    session.files.0.insert(of.path().to_owned(), applied.after);
    Ok((json!({ "files": [of.set], "changes": applied.changes }), report))
}
