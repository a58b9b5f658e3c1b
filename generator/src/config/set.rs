//! Reads a TOML set: its keys, its axes and the tables below them. No default, no rule, no file access.

use super::path::{self, Path};
use super::values::{Setting, Values};
use super::{axis_name, closest, list, other_kind, own_key, source::Source, toml_fault, toml_value, value};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::{Name, Scope, path_with};
use std::{collections::HashMap, sync::Arc};
use toml::Spanned;
use toml::de::{DeArray, DeString, DeTable, DeValue};

#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisTable<'a> {
    pub(crate) name: &'a str,
    pub(crate) name_at: usize,
    pub(crate) table: &'a DeTable<'a>,
}

/// Parses the file; `None` if it is not TOML, which has been reported.
pub(crate) fn parse<'s>(source: &'s Source, report: &mut Report) -> Option<Spanned<DeTable<'s>>> {
    let text = str::from_utf8(&source.bytes).map_err(|error| {
        let place = source.place(error.valid_up_to());
        report.push(Diagnostic::error(codes::UTF8, place, "not UTF-8").allowed("a TOML file is UTF-8"));
    });
    let text = text.ok()?;
    let (table, errors) = DeTable::parse_recoverable(text);
    if errors.is_empty() {
        return Some(table);
    }
    if let Some(said) = other_kind::instead_of_a_set(source) {
        report.push(said);
        return None;
    }
    let faults = errors.iter().map(|error| (error.span().map_or(0, |span| span.start), error.message().to_owned()));
    report.diagnostics.extend(toml_fault::said(source, text, faults));
    None
}

/// The keys of the set itself, and its axes.
type Top<'a> = (Values, Vec<AxisTable<'a>>);

pub(crate) fn top<'a>(source: &Arc<Source>, table: &'a DeTable<'a>, report: &mut Report) -> Top<'a> {
    let (mut values, mut axes) = (Values::default(), Vec::new());
    for (key, value) in in_file_order(table) {
        let written: &str = key.get_ref();
        let place = || source.place(key.span().start);
        match (path::find(written), value.get_ref()) {
            (_, DeValue::Table(tables)) if written == "axis" => axes = axes_of(source, tables, report),
            (_, other) if written == "axis" => report.push(no_table("axis", other, place())),
            (Path::Known { name, index, spelling, .. }, _) if name.parameter().scope == Scope::Set => {
                let setting = setting(source, (name, spelling), key, (written, value), report);
                values.insert((name, index), setting);
            }
            _ => {
                let of_a_set = Name::ALL.map(Name::parameter).into_iter().filter(|p| p.scope == Scope::Set);
                let keys: Vec<&str> = of_a_set.map(|parameter| parameter.path).collect();
                let found = format!("{} is not a key of a set", value::shown(written));
                let known = closest::nearest(written, keys.iter().copied().chain(["axis"]));
                let diagnostic = Diagnostic::error(codes::UNKNOWN, place(), found);
                let diagnostic = diagnostic.allowed(format!("{}, axis.NAME", keys.join(", ")));
                report.push(Diagnostic { instead: known.map(str::to_owned), ..diagnostic });
            }
        }
    }
    if axes.is_empty() && !report.has_errors() {
        report.push(Diagnostic::error(codes::NO_AXIS, source.whole(), "the set has no axis").instead("[axis.X]"));
    }
    (values, axes)
}

/// The axes with allowed names; each must be a table.
fn axes_of<'a>(source: &Source, axes: &'a DeTable<'a>, report: &mut Report) -> Vec<AxisTable<'a>> {
    let mut found = Vec::with_capacity(axes.len());
    let mut lines: HashMap<String, usize> = HashMap::with_capacity(axes.len());
    for (key, value) in in_file_order(axes) {
        let name: &str = key.get_ref();
        let name_at = key.span().start;
        if !axis_name::is_allowed(name) {
            let found = format!("{} is not a name for an axis", value::shown(name));
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
    below(source, axis.table, &mut String::new(), &mut values, report);
    values
}

/// The values below a table. The path of the axis itself is empty.
fn below(source: &Arc<Source>, table: &DeTable<'_>, path: &mut String, values: &mut Values, report: &mut Report) {
    if !path.is_empty() {
        path.push('.');
    }
    let above = path.len();
    for (key, value) in in_file_order(table) {
        path.truncate(above);
        path.push_str(key.get_ref());
        let place = || source.place(key.span().start);
        match (path::find(path), value.get_ref()) {
            (Path::Known { name, index, spelling, misprint: false }, _) if name.parameter().scope != Scope::Set => {
                let setting = setting(source, (name, spelling), key, (path, value), report);
                if let Some(first) = values.insert((name, index), setting) {
                    let line = first.path_place().line;
                    let found = format!("{} is given twice, first in line {line}", value::shown(path));
                    report.push(Diagnostic::error(codes::GIVEN_TWICE, place(), found).instead("one of the two"));
                }
            }
            (Path::OutOfRange { name, .. }, _) => report.push(list::out_of_range(name, path, place())),
            (_, DeValue::Table(table)) if path::is_structure(path) => {
                if table.is_empty() {
                    report.push(no_key(path, place()));
                }
                below(source, table, path, values, report);
            }
            (_, DeValue::Array(array)) if path::is_structure(&format!("{path}[]")) => {
                if array.is_empty() {
                    report.push(no_element(path, place()));
                }
                elements(source, array, path, values, report);
            }
            (_, other) => report.push(unknown(path, other, place())),
        }
    }
}

/// The values below the elements of an array.
fn elements(source: &Arc<Source>, array: &DeArray<'_>, path: &mut String, values: &mut Values, report: &mut Report) {
    let above = path.len();
    for (i, element) in array.iter().enumerate() {
        path.truncate(above);
        path.push_str(&format!("[{i}]"));
        match element.get_ref() {
            DeValue::Table(table) => below(source, table, path, values, report),
            other => report.push(no_table(path, other, source.place(element.span().start))),
        }
    }
}

/// The setting of a parameter; an unreadable value is reported.
fn setting(
    source: &Arc<Source>,
    (name, spelling): (Name, &'static str),
    key: &Spanned<DeString<'_>>,
    (written, value): (&str, &Spanned<DeValue<'_>>),
    report: &mut Report,
) -> Setting {
    let span = value.span();
    let with_radix = value::with_radix(name.parameter(), &source.bytes[span.clone()], &source.bytes[span.end..]);
    let at_value = |refused| vec![(span.start, refused)];
    let read = match with_radix {
        Some(refused) => Err(at_value(refused)),
        None => {
            toml_value::of_toml(name.parameter(), value).and_then(|read| own_key::fit(name, read).map_err(at_value))
        }
    };
    // An unreadable value in a list may belong to another function. A set is written for axgen: an unreadable key is an
    // error.
    let read = read.map_err(|wrong| {
        let said = wrong.into_iter().map(|(at, refused)| refused.diagnostic(name, written, source.place(at)));
        report.diagnostics.extend(said);
    });
    let (path_at, value_at) = (key.span().start, value.span().start);
    Setting { value: read.ok(), refused: None, spelling, source: Arc::clone(source), path_at, value_at }
}

/// A key that is not in the table, or a table instead of an array, or the reverse.
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
    let (what, instead) = match path::find(path) {
        Path::Known { name, index, misprint: true, .. } => {
            ("a misprint of the manual", Some(closest::in_a_set(&path_with(name.parameter().path, index), path)))
        }
        Path::Known { name, .. } => {
            let instead = format!("`{}` before the first table", name.parameter().path);
            ("a key of the set, not of an axis", Some(instead))
        }
        _ => {
            let is_table = matches!(value, DeValue::Table(_) | DeValue::Array(_));
            let alike = path::with_other_indices(path).map(|known| closest::with_indices_of(known, path));
            let meant = closest::of_id(path).or(alike).or_else(|| closest::path(path, is_table));
            ("not known", meant.map(|meant| closest::in_a_set(&meant, path)))
        }
    };
    Diagnostic { instead, ..Diagnostic::error(codes::UNKNOWN, place, format!("{shown} is {what}")) }
}

fn no_table(path: &str, value: &DeValue<'_>, place: Place) -> Diagnostic {
    let found = format!("{} is of type {}", value::shown(path), value.type_str());
    Diagnostic::error(codes::TYPE, place, found).allowed("a table")
}

/// Warns of an empty table: it asks for nothing, also where a block needs no more than defaults.
fn no_key(path: &str, place: Place) -> Diagnostic {
    let found = format!("{} is an empty table: it gives nothing", value::shown(path));
    let inside = format!("{}.", path::without_indices(path));
    let key =
        path::templates().find_map(|template| Some(path::without_indices(template).strip_prefix(&inside)?.to_owned()));
    let instead = key.map(|key| format!("no line, or a key in it, such as {key}"));
    Diagnostic { instead, ..Diagnostic::warning(codes::NO_EFFECT, place, found) }
}

/// Warns of an empty array: it does not remove anything from a list, as was probably meant.
fn no_element(path: &str, place: Place) -> Diagnostic {
    let found = format!("{} is an empty array: it gives nothing, and what a list has there stays", value::shown(path));
    let instead = match path.rsplit('.').next() {
        Some("stage") => {
            "stage = [{ mode = \"NOT_ACTIVE\" }, ...] for each stage of the list that is to go, or no line"
        }
        _ => "no line, or an element with its parameters",
    };
    Diagnostic::error(codes::TYPE, place, found).allowed("an array with an element at the least").instead(instead)
}

fn in_file_order<'a>(table: &'a DeTable<'a>) -> Vec<(&'a Spanned<DeString<'a>>, &'a Spanned<DeValue<'a>>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}
