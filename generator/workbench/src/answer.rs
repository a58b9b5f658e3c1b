//! The answer to each request: its data, and the messages.

use crate::request::{Request, Subject};
use crate::session::{Open, Session, load};
use crate::{curves, recorded, zip};
use commands::plan::Plan;
use commands::stages::{Number, Written};
use commands::verify::{Verification, engines};
use commands::words::{TIMES, made, seconds};
use commands::{check, diff, messages, refused, stages, trace};
use generator::blocks::{self, Designed};
use generator::diagnostics::Report;
use generator::pipeline::{self, Set};
use generator::target::{self, File, TARGETS, Target};
use generator::{codes, generate, manifest, params_of};
use golden::simulate::{self, Moved, picture, text};
use serde_json::{Value, json};
use std::path::Path;

type Answer = Result<(Value, Report), Report>;

/// The answer in JSON: `{ "data": ..., "messages": [...] }`; without data the request was refused.
pub fn answer(session: &mut Session, request: &str) -> String {
    let answer = match serde_json::from_str(request) {
        Ok(request) => answered(session, request),
        Err(error) => Err(refused::input(codes::USAGE, "request", error)),
    };
    let (data, report) = match answer {
        Ok((data, report)) => (Some(data), report),
        Err(report) => (None, report),
    };
    let load = load(&session.files);
    let again = |name: &str| load(Path::new(name)).ok();
    json!({ "data": data, "messages": messages::data(&report, &again) }).to_string()
}

fn answered(session: &mut Session, request: Request) -> Answer {
    match request {
        Request::Kinds { names } => {
            let bytes = |name: &String| session.files.0.get(Path::new(name));
            let kinds: Vec<_> = names.iter().map(|name| bytes(name).and_then(|bytes| recorded::kind(bytes))).collect();
            Ok((json!(kinds), Report::default()))
        }
        Request::Check { of } => check_set(session, &of),
        Request::Loop { axis } => Ok((json!(curves::curves(axis_of(session, &axis)?)), Report::default())),
        Request::Edit { of, axis, stage, value, to } => edit(session, &of, &axis, (stage, value, to)),
        Request::Page { axis, target } => {
            let (_, set) = allowed_set(session)?;
            let name = commands::axis(set, Some(&axis))?.axis.name.clone();
            let pages = generate::pages(set, &[name], &[target_of(&target)?], |page| page.file);
            let page =
                pages.first().ok_or_else(|| refused::input(codes::USAGE, axis, "has no improved position control"))?;
            Ok((as_json(page), Report::default()))
        }
        Request::Code { of, axis, target } => code(session, &of, &axis, target_of(&target)?),
        Request::Zip { of, targets, name } => archive(session, &of, &targets, &name),
        Request::Verify { samples } => verify(session, samples),
        Request::Diff { of, old } => difference(session, &of, &old),
        Request::Simulate { axis } => simulation(axis_of(session, &axis)?),
        Request::ParamsOf { of, axis, on, form } => parameters_of(session, &of, [&axis, &on, &form]),
        Request::Measure { of, axis, recording, excited } => {
            let cycle_time = axis.and_then(|axis| Some(axis_of(session, &axis).ok()?.axis.cycle_time()));
            let cycle_time = cycle_time.or_else(|| seconds(of.cycle_time.as_deref()?.trim(), &TIMES));
            recorded::measured(session, [Some(&recording), excited.as_deref()], cycle_time)
        }
        Request::Tune { of, axis, recording, excited } => {
            recorded::tuned(session, &of, &axis, [Some(&recording), excited.as_deref()])
        }
        Request::Apply { of, axis, proposal } => recorded::applied(session, &of, &axis, &proposal),
    }
}

/// Reads and checks. What has errors is shown as far as it can be read, but no block is generated from it.
fn check_set(session: &mut Session, of: &Subject) -> Answer {
    let (shown, mut report) = pipeline::read_to_show(of.path(), &of.options(), &load(&session.files));
    session.open(of, shown, &mut report);
    Ok((checked(session.set.as_ref(), &report), report))
}

fn checked(open: Option<&Open>, report: &Report) -> Value {
    let shown = open.map(|open| &open.shown);
    let checked = shown.map(|shown| check::check(&shown.set, report.warnings(), false));
    let text = checked.as_ref().map(check::Check::text);
    json!({
        "allowed": open.is_some_and(|open| open.allowed().is_some()),
        "whole": shown.is_some_and(|shown| shown.is_whole),
        "refused": shown.map(|shown| &shown.refused),
        "checked": checked,
        "text": text,
    })
}

/// Another number in the text of the user: what was read to prove it is the set from now on.
fn edit(session: &mut Session, of: &Subject, axis: &str, number: (usize, Number, f64)) -> Answer {
    let (options, load) = (of.options(), load(&session.files));
    let Written { files, shown, mut report } =
        stages::written((of.path(), &options, &load), axis_of(session, axis)?, number)?;
    drop(load);
    let names: Vec<String> = files.0.into_iter().map(|(path, bytes)| session.put(path, bytes)).collect();
    let curves = commands::axis(&shown.set, Some(axis)).map(curves::curves)?;
    session.open(of, Some(shown), &mut report);
    let data = json!({ "files": names, "checked": checked(session.set.as_ref(), &report), "loop": curves });
    Ok((data, report))
}

fn code(session: &Session, of: &Subject, axis: &str, target: Target) -> Answer {
    let designed = allowed(session, axis)?;
    let of = Subject { responses: Vec::new(), ..of.clone() };
    let (options, load) = (of.options(), load(&session.files));
    let blocks = made(blocks::blocks(designed));
    let trace = trace::trace((of.path(), &options, &load), designed, &blocks, &[target])?;
    let emitted: Value = trace.files.iter().map(as_json).collect();
    Ok((json!({ "emitted": emitted, "trace": trace }), Report::default()))
}

fn shown_of(session: &Session) -> Result<&Open, Report> {
    session.set.as_ref().ok_or_else(|| refused::input(codes::USAGE, "set", "no set that can be read is open"))
}

fn axis_of<'s>(session: &'s Session, name: &str) -> Result<&'s Designed, Report> {
    commands::axis(&shown_of(session)?.shown.set, Some(name))
}

/// The set as the command reads it, if it is free of errors.
fn allowed_set(session: &Session) -> Result<(&str, &Set), Report> {
    let open = shown_of(session)?;
    let refused = || refused::input(codes::USAGE, &open.name, "has errors: no block is generated from it");
    open.allowed().map(|shown| (open.name.as_str(), &shown.set)).ok_or_else(refused)
}

/// An axis of a set without errors.
fn allowed<'s>(session: &'s Session, axis: &str) -> Result<&'s Designed, Report> {
    commands::axis(allowed_set(session)?.1, Some(axis))
}

fn target_of(name: &str) -> Result<Target, Report> {
    let known = TARGETS.map(|target| target.name);
    target::named(name).ok_or_else(|| refused::no_such("target", "target", name, &known))
}

fn as_json(file: &File) -> Value {
    json!({ "name": file.name, "text": file.text })
}

/// All files of the set for these targets: the content of a folder that was empty.
fn files(session: &Session, targets: &[String]) -> Result<Vec<File>, Report> {
    let (path, set) = allowed_set(session)?;
    let targets: Vec<Target> = commands::generate::targets(targets, &set.targets, [])?;
    Ok(Plan::whole(set, &targets).folder(&manifest::set_name(Path::new(path))))
}

/// The generated files below `generated/`, and every file of the user next to it.
fn archive(session: &mut Session, of: &Subject, targets: &[String], name: &str) -> Answer {
    let files = files(session, targets)?;
    let names: Vec<String> = files.iter().map(|file| format!("generated/{}", file.name)).collect();
    let generated = names.iter().zip(&files).map(|(name, file)| (name.as_str(), file.text.as_bytes()));
    let own = session.files.0.iter().filter_map(|(path, bytes)| Some((path.to_str()?, bytes.as_slice())));
    let archive = zip::archive(own.chain(generated));
    let archive = archive.ok_or_else(|| refused::input(codes::TOO_LARGE, &of.set, "is too large for a zip file"))?;
    let answer = json!({ "files": [name], "entries": names, "bytes": archive.len() });
    session.archive = Some((name.to_owned(), archive));
    Ok((answer, Report::default()))
}

fn verify(session: &Session, samples: usize) -> Answer {
    let mut engines = engines(&[])?;
    engines.retain(|engine| !engine.is_compiled());
    let mut verification = Verification::new(&engines, &|_, _| None);
    let (mut rows, mut reached) = (Vec::new(), Vec::new());
    let Open { name, shown, .. } = shown_of(session)?;
    if !shown.is_whole {
        return Err(refused::input(codes::USAGE, name, "has errors: not every block can be run"));
    }
    for designed in &shown.set.axes {
        let (of_axis, lines) = verification.blocks(designed, &made(blocks::blocks(designed)), samples);
        rows.extend(of_axis);
        reached.extend(lines);
    }
    Ok((json!({ "rows": rows, "reached": reached }), verification.missing()))
}

fn difference(session: &Session, of: &Subject, old: &str) -> Answer {
    let files = [Path::new(old), of.path()];
    let [(before, of_old), (after, of_new)] = diff::read(files, &of.options(), &load(&session.files));
    match (before, after) {
        (Some(before), Some(after)) => Ok((json!(diff::diff(files, before, &after)), of_new)),
        (None, _) => Err(of_old),
        (_, None) => Err(of_new),
    }
}

fn simulation(designed: &Designed) -> Answer {
    let simulation = simulate::run(designed, Moved::Drive, None)
        .map_err(|why| refused::input(codes::USAGE, &designed.axis.name, why))?;
    let answer = json!({
        "text": text::table(&simulation, designed),
        "picture": picture::of(&simulation, &designed.axis.name).map(|picture| picture.svg()),
    });
    Ok((answer, Report::default()))
}

fn parameters_of(session: &Session, of: &Subject, [axis, on, form]: [&str; 3]) -> Answer {
    let form = params_of::Form::named(form).ok_or_else(|| {
        let known = params_of::Form::ALL.map(|(name, _)| name);
        refused::no_such("form", "form", form, &known)
    })?;
    let load = load(&session.files);
    let [(before, of_old), (after, of_new)] = diff::read_for_set([Path::new(on), of.path()], &of.options(), &load);
    let (before, after) = (before.ok_or(of_old)?, after.ok_or(of_new)?);
    let (old, new) = (commands::axis(&before, Some(axis))?, commands::axis(&after, Some(axis))?);
    let report = params_of::check(new, old, [&of.set, on]);
    if report.has_errors() {
        return Err(report);
    }
    let bytes = made(params_of::bytes(new, form));
    Ok((json!({ "text": String::from_utf8_lossy(&bytes), "bytes": bytes }), report))
}
