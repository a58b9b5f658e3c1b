//! From a file to its designed axes: read, check, design, feasibility. Only this file calls these steps.

use crate::blocks::ipc::drive_response;
use crate::blocks::{self, Designed};
use crate::check::{self, Checked, cnc_functions, gantry};
use crate::config::given::{self, GivenAxis};
use crate::config::{ListOptions, Load, file, values::key};
use crate::diagnostics::{Diagnostic, Place, Report, Severity};
use crate::target::block_name;
use crate::{axis::Axis, codes, feasibility, parameters::Name};
use rayon::prelude::*;
use serde::Serialize;
use std::{collections::BTreeMap, path::Path};

/// The axes of a set, checked and designed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Set {
    /// targets if the command line names none; empty if the set names none either
    pub targets: Vec<String>,
    /// in the order of the file
    pub axes: Vec<Designed>,
    /// the number of skipped parameters of other functions in its lists
    pub foreign: usize,
}

/// A set as far as it could be read, for a page that shows it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shown {
    /// with the axes that could be designed, also if a loop is unstable
    pub set: Set,
    /// the other axes
    pub refused: Vec<RefusedAxis>,
    /// whether no message is an error: blocks may be generated
    pub is_allowed: bool,
    /// whether no message is an error, except about an unstable loop
    pub is_whole: bool,
}

/// An axis that could not be designed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RefusedAxis {
    pub axis: String,
    /// what its first error says, else the first one of the set
    pub found: String,
}

/// Reads, checks and designs a TOML set (`.toml`) or one axis list (any other extension). The set is `Some` if and only if
/// no message is an error.
pub fn read(path: &Path, options: &ListOptions) -> (Option<Set>, Report) {
    read_with(path, options, &file::load)
}

/// Reads a set for a command that shows its effect and writes no block: an unstable loop is only a warning.
pub fn read_to_look_at(path: &Path, options: &ListOptions, load: Load<'_>) -> (Option<Set>, Report) {
    complete(read_as(path, options, load, Purpose::Look))
}

/// Reads a set for a command that proposes stages: the drive is read even if no stage is active yet.
pub fn read_to_tune(path: &Path, options: &ListOptions, load: Load<'_>) -> (Option<Set>, Report) {
    complete(read_as(path, options, load, Purpose::Tune))
}

/// Reads a set as [`read`] does, from another source of files.
pub fn read_with(path: &Path, options: &ListOptions, load: Load<'_>) -> (Option<Set>, Report) {
    complete(read_as(path, options, load, Purpose::Build))
}

/// Reads a set with the messages of [`read_with`], and keeps what could be read. `None` if its file cannot be read at all.
pub fn read_to_show(path: &Path, options: &ListOptions, load: Load<'_>) -> (Option<Shown>, Report) {
    read_as(path, options, load, Purpose::Show)
}

fn complete((shown, report): (Option<Shown>, Report)) -> (Option<Set>, Report) {
    (shown.filter(|shown| shown.is_allowed).map(|shown| shown.set), report)
}

/// The purpose of reading a set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Purpose {
    /// blocks that act on a machine
    Build,
    /// blocks, and display of what has errors
    Show,
    /// only display
    Look,
    /// its drive, for stages that it does not have yet
    Tune,
}

fn read_as(path: &Path, options: &ListOptions, load: Load<'_>, purpose: Purpose) -> (Option<Shown>, Report) {
    let given = match given::read(path, options, load) {
        Ok(given) => given,
        Err(report) => return (None, report.shortened()),
    };
    let mut report = given.report;
    report.extend(gantry::numbers(&given.axes));
    let cycle_time = check::cycle_time(&given.top, given.no_cycle_time, &mut report);
    let mut checked: Vec<Option<Checked<'_>>> = (given.axes.par_iter())
        .map(|axis| {
            let (values, home) = (axis.values.as_ref()?, axis.home.clone());
            Some(check::axis(&axis.name, cycle_time, values, home, purpose == Purpose::Tune))
        })
        .collect();
    // The design of a slave depends on its master. If axes are missing, nothing is reported about that.
    let has_errors = report.has_errors() || given.axes.iter().any(|axis| axis.report.has_errors());
    let coupling = if has_errors { None } else { couple(&mut checked, given.is_list) };
    let designed = given.axes.par_iter().zip(checked).map(|axis| design(axis, (path, load), purpose)).collect();
    let mut set = Set { targets: check::targets(&given.top), ..Set::default() };
    set.foreign = given.axes.iter().map(|axis| axis.foreign.count).sum();
    let mut refused = divide(&given.axes, designed, &mut set.axes, &mut report);
    if !report.has_errors() {
        report.extend(coupling.unwrap_or_default());
    }
    for axis in refused.iter_mut().filter(|axis| axis.found.is_empty()) {
        axis.found = first_error(&report);
    }
    let is_whole = refused.is_empty() && !report.diagnostics.iter().any(is_refusal);
    let shown = Shown { set, refused, is_allowed: !report.has_errors(), is_whole };
    (Some(shown), report.shortened())
}

/// Adds the axes that could be designed, and the messages about all of them; returns the others.
fn divide(
    given: &[GivenAxis],
    designed: Vec<(Option<Designed>, Report)>,
    axes: &mut Vec<Designed>,
    report: &mut Report,
) -> Vec<RefusedAxis> {
    let (mut refused, mut names) = (Vec::new(), BTreeMap::new());
    for (of, (designed, said)) in given.iter().zip(designed) {
        if designed.is_none() {
            refused.push(RefusedAxis { axis: of.name.clone(), found: first_error(&said) });
        }
        report.extend(said);
        report.diagnostics.extend(designed.as_ref().and_then(|designed| name_twice(designed, &of.home, &mut names)));
        axes.extend(designed);
    }
    refused
}

/// Rejects a block whose name the block of another axis has: `spindle_axis` of S, and `axis` of S_spindle.
fn name_twice(designed: &Designed, place: &Place, names: &mut BTreeMap<String, String>) -> Option<Diagnostic> {
    let name = &designed.axis.name;
    let taken = |block| {
        let other = names.insert(block_name(name, block), name.clone())?;
        (!other.eq_ignore_ascii_case(name)).then_some((block, other))
    };
    let (block, other) = blocks::names(&designed.axis).into_iter().find_map(taken)?;
    let found =
        format!("the block `{block}` of {name} has the same name as one of {other}: {}", block_name(name, block));
    Some(Diagnostic::error(codes::AXIS_TWICE, place.clone(), found).instead("another name"))
}

/// What the first error says.
fn first_error(report: &Report) -> String {
    let error = report.diagnostics.iter().find(|diagnostic| diagnostic.severity == Severity::Error);
    error.map_or_else(String::new, |error| error.found.clone())
}

/// Whether a message is an error that leaves nothing to be shown.
fn is_refusal(diagnostic: &Diagnostic) -> bool {
    diagnostic.severity == Severity::Error && diagnostic.code != codes::UNSTABLE
}

/// Couples gantry slaves to their masters, if all axes are available; returns the messages.
fn couple(checked: &mut [Option<Checked<'_>>], is_list: bool) -> Option<Report> {
    let axes = checked.iter_mut().map(|checked| {
        let Checked { axis, effective, .. } = checked.as_mut()?;
        Some((axis.as_mut()?, effective.place_of(key(Name::GantryMaster))))
    });
    let (mut axes, places): (Vec<&mut Axis>, Vec<Place>) = axes.collect::<Option<_>>()?;
    match axes.as_mut_slice() {
        [axis] if is_list => Some(gantry::alone(axis, places[0].clone())),
        axes => Some(gantry::couple(axes, &places)),
    }
}

/// Designs an axis and reports all messages about it. Not checked if its values cannot be read.
fn design(
    (given, checked): (&GivenAxis, Option<Checked<'_>>),
    (set, load): (&Path, Load<'_>),
    purpose: Purpose,
) -> (Option<Designed>, Report) {
    let mut report = given.report.clone();
    let (Some(Checked { axis, gear, mut effective }), Some(values)) = (checked, &given.values) else {
        return (None, report);
    };
    let mut designed = axis.map(Designed::from);
    let has_drive = |designed: &&mut Designed| purpose == Purpose::Tune || designed.axis.ipc.is_active();
    if let Some(designed) = designed.as_mut().filter(has_drive) {
        designed.axis.drive.response = drive_response::read(designed, values, (set, load), &mut effective);
    }
    if let Some(designed) = &designed {
        feasibility::validate(designed, gear, &mut effective);
        cnc_functions::advise(&designed.axis, &given.foreign, &mut effective);
    }
    let mut said = effective.report;
    if matches!(purpose, Purpose::Look | Purpose::Tune) {
        let unstable = said.diagnostics.iter_mut().filter(|diagnostic| diagnostic.code == codes::UNSTABLE);
        unstable.for_each(|diagnostic| diagnostic.severity = Severity::Warning);
    }
    let designed = designed.filter(|_| !match purpose {
        Purpose::Show => report.has_errors() || said.diagnostics.iter().any(is_refusal),
        Purpose::Build | Purpose::Look | Purpose::Tune => said.has_errors(),
    });
    let unread = values.unread(&said);
    said.diagnostics.extend(unread);
    if report.has_errors() {
        // Unreadable values are missing: advice about the others would mislead.
        said.diagnostics.retain(|diagnostic| diagnostic.severity == Severity::Error);
    }
    report.extend(said);
    (designed, report)
}
