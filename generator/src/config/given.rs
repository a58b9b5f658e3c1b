//! The contents of a set or a list: the values of its top and of each of its axes. Files are read here; nothing is
//! validated.

use super::list::{self, List};
use super::other_functions::{self, Found, OtherFunctions};
use super::project::{self, AxisList};
use super::set::{self, AxisTable};
use super::value::{self, shown};
use super::values::{Setting, Values, key};
use super::{axis_name, file, file::Load, other_kind, own_key, source::Source};
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::{codes, parameters::Name};
use rayon::prelude::*;
use std::{collections::BTreeMap, path::Path, sync::Arc};

/// The path of the stages of an axis, without their index.
pub(crate) const ABOVE_STAGES: &str = "lr_param.improved_position_control.stage";

/// Values that a list cannot contain, for a list without a set.
#[derive(Clone, Debug, Default)]
pub struct ListOptions {
    pub cycle_time: Option<String>,
    /// `--name`; otherwise the axis has the file's name
    pub name: Option<String>,
    /// options that correspond to keys of an axis, in a list or in a set: they override its keys
    pub keys: Vec<OptionKey>,
}

/// An option that corresponds to a key of an axis.
#[derive(Clone, Debug)]
pub struct OptionKey {
    /// the axis; `None`: every axis
    pub axis: Option<String>,
    /// `--delay`
    pub option: String,
    pub name: Name,
    /// those of the parameter; 0 where it has none
    pub index: [u32; 2],
    pub text: String,
}

pub(crate) struct Given {
    /// `cycle_time`, `targets`
    pub(crate) top: Values,
    pub(crate) no_cycle_time: Diagnostic,
    pub(crate) is_list: bool,
    pub(crate) axes: Vec<GivenAxis>,
    /// messages about the file, except those about its axes
    pub(crate) report: Report,
}

pub(crate) struct GivenAxis {
    pub(crate) name: String,
    /// the place where the set names it; for a list the whole file
    pub(crate) home: Place,
    /// `None` if its list cannot be read, which has been reported
    pub(crate) values: Option<Values>,
    /// parameters of other functions in its list, which were skipped
    pub(crate) foreign: OtherFunctions,
    /// messages about its lines
    pub(crate) report: Report,
}

/// Reads a TOML set (`.toml`), an axis list, or a project of TwinCAT with axis lists (any other extension).
pub(crate) fn read(path: &Path, options: &ListOptions, load: Load<'_>) -> Result<Given, Report> {
    let source = file::read(path, None, load)?;
    let mut given =
        if file::is_set(path) { of_set(path, &source, options, load)? } else { of_lists(path, &source, options)? };
    let Given { axes, report, .. } = &mut given;
    let keys: Vec<(&OptionKey, Setting)> =
        options.keys.iter().map(|key| (key, setting_of_option(&key.option, key.name, &key.text, report))).collect();
    let has_stages = options.keys.iter().any(|key| is_of_stage(key.name));
    for GivenAxis { name, values, .. } in axes.iter_mut().filter(|_| !keys.is_empty()) {
        let Some(values) = values else { continue };
        // A stage that is given as an option takes nothing from those of the axis.
        values.retain(|(name, _)| !has_stages || !is_of_stage(name));
        let mut own = Values::default();
        for (key, setting) in keys.iter().filter(|(key, _)| key.axis.as_ref().is_none_or(|axis| axis == name)) {
            own.insert((key.name, key.index), setting.clone());
        }
        *values = std::mem::take(values).overridden_by(own);
    }
    Ok(given)
}

fn of_set(path: &Path, source: &Arc<Source>, options: &ListOptions, load: Load<'_>) -> Result<Given, Report> {
    let mut report = Report::default();
    for (option, given, instead) in [
        ("--cycle-time", &options.cycle_time, "the key `cycle_time` of the set"),
        ("--name", &options.name, "the name in [axis.NAME]"),
    ] {
        if given.is_some() {
            let found = format!("{option} is for a single axis list; this is a set");
            report.push(Diagnostic::error(codes::OPTION, Place::whole(option), found).instead(instead));
        }
    }
    let Some(table) = set::parse(source, &mut report) else { return Err(report) };
    let (top, axes) = set::top(source, table.get_ref(), &mut report);
    let cycle_time = top.get(key(Name::CycleTime));
    let axes = axes.par_iter().map(|axis| of_axis(source, *axis, path, cycle_time, load)).collect();
    let no_cycle_time = Diagnostic::error(codes::CYCLE_TIME, source.whole(), "the set has no cycle time")
        .instead("cycle_time = \"1ms\", if that is its cycle");
    Ok(Given { top, no_cycle_time, is_list: false, axes, report })
}

/// The keys of an axis over the values of its list.
fn of_axis(
    source: &Arc<Source>,
    axis: AxisTable<'_>,
    set: &Path,
    cycle_time: Option<&Setting>,
    load: Load<'_>,
) -> GivenAxis {
    let mut report = Report::default();
    let keys = set::values_of(source, axis, &mut report);
    let home = source.place(axis.name_at);
    let mut given =
        GivenAxis { name: axis.name.to_owned(), home, values: None, foreign: OtherFunctions::default(), report };
    match list_of(&keys, axis.name, set, load) {
        None => given.values = Some(keys),
        Some(Err(unreadable)) => given.report.extend(unreadable),
        Some(Ok(list)) => {
            let list = read_as_list(&list);
            given.report.extend(list.report);
            given.report.diagnostics.extend(own_key::unread(&list.own, &keys, cycle_time));
            given.report.diagnostics.extend(other_axis(axis.name, &list.foreign));
            given.foreign = list.foreign;
            given.values = list.complete.then(|| list.values.overridden_by(keys));
            given.report.diagnostics.extend(given.values.iter().flat_map(|values| given.foreign.mistyped(values)));
        }
    }
    given
}

/// The message if a list contains the name of another axis than the set gives it.
fn other_axis(name: &str, list: &OtherFunctions) -> Option<Diagnostic> {
    let letters = |name: &str| -> String {
        name.chars().filter(|letter| letter.is_ascii_alphanumeric()).map(|letter| letter.to_ascii_lowercase()).collect()
    };
    let Found { text, place } = list.get(other_functions::NAME)?;
    let in_list = text.trim_matches(['"', '\'', ' ', '\t']);
    let is_same = letters(in_list) == letters(name) || letters(in_list).is_empty();
    let found = format!("the list of the axis {name} has the name of another axis: {}", shown(in_list));
    let said = Diagnostic::warning(codes::OTHER_AXIS, place.clone(), found);
    (!is_same)
        .then(|| said.instead(format!("in [axis.{name}] the list of this axis, or the axis with the name in the list")))
}

/// The list that an axis of a set names; `None` if it names no list.
pub(crate) fn list_of(keys: &Values, axis: &str, set: &Path, load: Load<'_>) -> Option<Result<AxisList, Report>> {
    let (list, setting) = keys.text(Name::List)?;
    let path = set.parent().unwrap_or(Path::new("")).join(list);
    let source = file::read(&path, Some(setting), load);
    Some(source.and_then(|source| project::of_axis(project::lists(&source)?, Some(axis))))
}

/// The names of the axes of a project with several axis lists; of any other file none.
#[must_use]
pub fn axes_of_project(path: &Path, load: Load<'_>) -> Vec<String> {
    let lists = file::read(path, None, load).and_then(|source| project::lists(&source)).unwrap_or_default();
    let is_project = lists.len() > 1;
    lists.into_iter().filter(|_| is_project).filter_map(|list| list.name).collect()
}

/// A list, or the lists of a project, from which `--name` selects one.
fn of_lists(path: &Path, source: &Arc<Source>, options: &ListOptions) -> Result<Given, Report> {
    let mut report = Report::default();
    let no_cycle_time = "no axis list holds the cycle time of the position controller";
    let no_cycle_time = Diagnostic::error(codes::CYCLE_TIME, source.whole(), no_cycle_time)
        .instead("--cycle-time 1ms, if that is its cycle");
    let top = cycle_time_of(options, &mut report);
    let mut lists = project::lists(source)?;
    if options.name.is_some() {
        lists = vec![project::of_axis(lists, options.name.as_deref())?];
    }
    let axes: Vec<GivenAxis> = lists.iter().map(|list| of_list(path, list, options, &top, &mut report)).collect();
    let mut first = BTreeMap::new();
    for (axis, list) in axes.iter().zip(&lists) {
        let first = first.entry(axis.name.to_ascii_lowercase()).or_insert(list);
        if !std::ptr::eq(*first, list) {
            report.push(list.twice(first, &axis.name));
        }
    }
    Ok(Given { top, no_cycle_time, is_list: axes.len() == 1, axes, report })
}

fn of_list(path: &Path, list: &AxisList, options: &ListOptions, top: &Values, report: &mut Report) -> GivenAxis {
    let name = name_of(path, list, options, report);
    let List { values, own, foreign, mut report, complete } = read_as_list(list);
    report.diagnostics.extend(own_key::unread(&own, &Values::default(), top.get(key(Name::CycleTime))));
    let values = complete.then_some(values);
    report.diagnostics.extend(values.iter().flat_map(|values| foreign.mistyped(values)));
    GivenAxis { name, home: list.place(), foreign, report, values }
}

/// The contents of a list, or a message about the probable kind of the file.
fn read_as_list(list: &AxisList) -> List {
    let read = list::read(list);
    match other_kind::instead_of_a_list(list, &read) {
        Some(said) => List { report: said.into(), complete: false, ..read },
        None => read,
    }
}

/// The name of the axis of a list: from the command line, the project, or the file.
pub(crate) fn name_of(path: &Path, list: &AxisList, options: &ListOptions, report: &mut Report) -> String {
    let name = options.name.clone().or_else(|| list.name.clone()).unwrap_or_else(|| axis_name::of_file(path));
    if !axis_name::is_allowed(&name) {
        let found = format!("{} is not a name for an axis", shown(&name));
        let said = |place| Diagnostic::error(codes::AXIS_NAME, place, found).allowed(axis_name::ALLOWED);
        report.push(match options.name {
            Some(_) => said(Place::whole("--name")),
            None => said(list.source.whole()).instead("--name NAME"),
        });
    }
    name
}

/// The cycle time of the command line, as a key.
pub(crate) fn cycle_time_of(options: &ListOptions, report: &mut Report) -> Values {
    let mut values = Values::default();
    if let Some(text) = &options.cycle_time {
        values.insert(key(Name::CycleTime), setting_of_option("--cycle-time", Name::CycleTime, text, report));
    }
    values
}

/// An option, as a key.
fn setting_of_option(option: &str, name: Name, text: &str, report: &mut Report) -> Setting {
    let parameter = name.parameter();
    let value = value::of_text(parameter, text)
        .map_err(|refused| report.push(refused.diagnostic(name, option, Place::whole(option))));
    let source = Source::option(option, text);
    Setting { value: value.ok(), refused: None, spelling: parameter.path, source, path_at: 0, value_at: 0 }
}

/// Whether a parameter belongs to a stage.
pub(crate) fn is_of_stage(name: Name) -> bool {
    name.parameter().path.starts_with(ABOVE_STAGES)
}
