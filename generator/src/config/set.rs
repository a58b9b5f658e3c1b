//! Reading a TOML set: its keys, its axes and the tables below them. No default, no rule, no file access of its own.

use super::path::{self, Path};
use super::source::Source;
use super::values::{Setting, Values};
use super::{axis_name, closest, list, value};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::{Kind, Name, Scope, path_with};
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

#[derive(Debug, Default)]
pub(crate) struct Top<'a> {
    /// `cycle_time`, `targets`
    pub(crate) values: Values,
    pub(crate) axes: Vec<AxisTable<'a>>,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisTable<'a> {
    pub(crate) name: &'a str,
    pub(crate) name_at: usize,
    pub(crate) table: &'a DeTable<'a>,
}

/// More faults of syntax than these are not listed: they follow from the first.
const SYNTAX_FAULTS: usize = 20;

type Entry<'a> = (&'a Spanned<DeString<'a>>, &'a Spanned<DeValue<'a>>);

/// Parses the file.
pub(crate) fn parse(source: &Source) -> Result<Spanned<DeTable<'_>>, Report> {
    let mut report = Report::default();
    let text = match str::from_utf8(&source.bytes) {
        Ok(text) => text,
        Err(error) => {
            let place = source.place(error.valid_up_to());
            report.push(Diagnostic::error(codes::UTF8, place, "not UTF-8").allowed("a TOML file is UTF-8"));
            return Err(report);
        }
    };
    let (table, errors) = DeTable::parse_recoverable(text);
    if errors.is_empty() {
        return Ok(table);
    }
    for error in errors.iter().take(SYNTAX_FAULTS) {
        let place = source.place(error.span().map_or(0, |span| span.start).min(source.bytes.len()));
        report.push(Diagnostic::error(codes::SYNTAX, place, format!("no TOML: {}", error.message())));
    }
    Err(report)
}

pub(crate) fn top<'a>(source: &Arc<Source>, table: &'a DeTable<'a>, report: &mut Report) -> Top<'a> {
    let mut top = Top::default();
    for (key, value) in in_file_order(table) {
        let place = || source.place(key.span().start);
        match (key.get_ref().as_ref(), path::find(key.get_ref())) {
            ("axis", _) => match value.get_ref() {
                DeValue::Table(axes) => top.axes = axes_of(source, axes, report),
                other => report.push(no_table("axis", other, place())),
            },
            (_, Path::Known { name, index, spelling, .. }) if name.parameter().scope == Scope::Set => {
                let setting = setting(source, (name, spelling), key, (key.get_ref(), value), report);
                top.values.insert((name, index), setting);
            }
            (written, _) => {
                let keys =
                    Name::ALL.iter().map(|name| name.parameter()).filter(|p| p.scope == Scope::Set).map(|p| p.path);
                let found = format!("{} is no key of a set", value::shown(written));
                let known = closest::of(written, keys.clone().chain(["axis"]));
                let allowed = keys.chain(["axis.NAME"]).collect::<Vec<_>>().join(", ");
                let diagnostic = Diagnostic::error(codes::UNKNOWN, place(), found).allowed(allowed);
                report.push(Diagnostic { instead: known.map(str::to_owned), ..diagnostic });
            }
        }
    }
    if top.axes.is_empty() && !report.has_errors() {
        report.push(Diagnostic::error(codes::NO_AXIS, source.whole(), "the set has no axis").instead("[axis.X]"));
    }
    top
}

/// The axes with allowed names, each a table.
fn axes_of<'a>(source: &Source, axes: &'a DeTable<'a>, report: &mut Report) -> Vec<AxisTable<'a>> {
    let mut found = Vec::with_capacity(axes.len());
    let mut lines: HashMap<String, usize> = HashMap::with_capacity(axes.len());
    for (key, value) in in_file_order(axes) {
        let name: &str = key.get_ref();
        let name_at = key.span().start;
        if !axis_name::is_allowed(name) {
            let found = format!("{} is no name for an axis", value::shown(name));
            report.push(Diagnostic::error(codes::AXIS_NAME, source.place(name_at), found).allowed(axis_name::ALLOWED));
        } else if let Some(first) = lines.insert(name.to_ascii_lowercase(), name_at) {
            let line = source.place(first).line;
            let found =
                format!("`{name}` differs only in case from the axis in line {line}; Structured Text sees one name");
            report.push(Diagnostic::error(codes::AXIS_TWICE, source.place(name_at), found).instead("another name"));
        }
        match value.get_ref() {
            DeValue::Table(table) => found.push(AxisTable { name, name_at, table }),
            other => report.push(no_table(&format!("axis.{name}"), other, source.place(name_at))),
        }
    }
    found
}

pub(crate) fn values_of(source: &Arc<Source>, axis: AxisTable<'_>, report: &mut Report) -> Values {
    let mut values = Values::default();
    let mut path = String::new();
    below(source, axis.table, &mut path, &mut values, report);
    values
}

fn below(source: &Arc<Source>, table: &DeTable<'_>, path: &mut String, values: &mut Values, report: &mut Report) {
    let length = path.len();
    for (key, value) in in_file_order(table) {
        path.truncate(length);
        if length > 0 {
            path.push('.');
        }
        path.push_str(key.get_ref());
        match (path::find(path), value.get_ref()) {
            (Path::Known { name, index, spelling, misprint: false }, _) if name.parameter().scope != Scope::Set => {
                let setting = setting(source, (name, spelling), key, (path, value), report);
                if let Some(first) = values.insert((name, index), setting) {
                    let line = first.path_place().line;
                    let found = format!("{} is given twice, first in line {line}", value::shown(path));
                    let diagnostic = Diagnostic::error(codes::GIVEN_TWICE, source.place(key.span().start), found);
                    report.push(diagnostic.instead("one of the two"));
                }
            }
            (Path::OutOfRange { name, .. }, _) => {
                report.push(list::out_of_range(name, path, source.place(key.span().start)));
            }
            (_, DeValue::Table(table)) if path::is_structure(path) => below(source, table, path, values, report),
            (_, DeValue::Array(array)) if path::is_structure(&format!("{path}[]")) => {
                let length = path.len();
                for (i, element) in array.iter().enumerate() {
                    path.truncate(length);
                    path.push_str(&format!("[{i}]"));
                    match element.get_ref() {
                        DeValue::Table(table) => below(source, table, path, values, report),
                        other => report.push(no_table(path, other, source.place(element.span().start))),
                    }
                }
            }
            (_, other) => report.push(unknown(path, other, source.place(key.span().start))),
        }
    }
    path.truncate(length);
}

/// What was given for a parameter: its value, unless that is none, which is said.
fn setting(
    source: &Arc<Source>,
    (name, spelling): (Name, &'static str),
    key: &Spanned<DeString<'_>>,
    (written, value): (&str, &Spanned<DeValue<'_>>),
    report: &mut Report,
) -> Setting {
    let Range { start: value_at, .. } = value.span();
    let said = |at, refused: value::Refused| refused.diagnostic(name, written, source.place(at));
    let parameter = name.parameter();
    // A list may have a value that nobody can read for other functions; a set is written for us, and none of its keys is.
    let value = match (parameter.kind, value.get_ref()) {
        // Each wrong word is told at its own place.
        (Kind::Words(words), DeValue::Array(array)) => value::of_array(parameter, words, array)
            .map_err(|wrong| report.diagnostics.extend(wrong.into_iter().map(|(at, refused)| said(at, refused))))
            .ok(),
        (_, other) => value::of_toml(parameter, other).map_err(|refused| report.push(said(value_at, refused))).ok(),
    };
    Setting { value, refused: None, spelling, source: Arc::clone(source), path_at: key.span().start, value_at }
}

/// A key that is not in the table, or a table or an array where the other is needed.
fn unknown(path: &str, value: &DeValue<'_>, place: Place) -> Diagnostic {
    let shown = value::shown(path);
    if path::is_structure(path) {
        return no_table(path, value, place);
    }
    if path::is_structure(&format!("{path}[]")) {
        let found = format!("{shown} is of type {}", value.type_str());
        let end = path.rsplit('.').next().unwrap_or(path);
        let instead = format!("{end} = [{{ ... }}], or [[...{end}]] for each");
        return Diagnostic::error(codes::TYPE, place, found).allowed("an array of tables").instead(instead);
    }
    if let Path::Known { name, index, misprint: true, .. } = path::find(path) {
        let found = format!("{shown} is a misprint of the manual");
        return Diagnostic::error(codes::UNKNOWN, place, found).instead(path_with(name.parameter().path, index));
    }
    if let Path::Known { name, .. } = path::find(path) {
        let found = format!("{shown} is a key of the set, not of an axis");
        let instead = format!("`{}` before the first table", name.parameter().path);
        return Diagnostic::error(codes::UNKNOWN, place, found).instead(instead);
    }
    let is_table = matches!(value, DeValue::Table(_) | DeValue::Array(_));
    let known = if is_table { closest::structure(path) } else { None }.or_else(|| closest::path(path));
    let diagnostic = Diagnostic::error(codes::UNKNOWN, place, format!("{shown} is not known"));
    Diagnostic { instead: known, ..diagnostic }
}

fn no_table(path: &str, value: &DeValue<'_>, place: Place) -> Diagnostic {
    let found = format!("{} is of type {}", value::shown(path), value.type_str());
    Diagnostic::error(codes::TYPE, place, found).allowed("a table")
}

fn in_file_order<'a>(table: &'a DeTable<'a>) -> Vec<Entry<'a>> {
    let mut entries: Vec<Entry<'a>> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}
