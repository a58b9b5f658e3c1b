//! An axis of a set as an axis list: which lines it came from, and which values it has now. No line is written here.

use super::encoding::Encoded;
use super::fill::Filling;
use crate::config::{AxisTable, Load, Source, Values, file, given, list, set, shown};
use crate::diagnostics::{Diagnostic, Report};
use crate::parameters::words::{LineEnd, ListEncoding};
use crate::{codes, parameters::Name};
use std::{path::Path, sync::Arc};

/// An axis of a TOML set (`.toml`) as an axis list; without a name the only one. An axis list (any other extension) is
/// given as it is. The list is there if, and only if, no message is an error. The rules between parameters are not checked.
pub fn export(path: &Path, axis: Option<&str>, load: Load<'_>) -> (Option<Vec<u8>>, Report) {
    let mut report = Report::default();
    let list = match file::read(path, None, load) {
        Ok(source) if file::is_set(path) => of_set(&source, path, axis, load, &mut report),
        Ok(source) => {
            report.extend(list::read_to_keep(&source).report);
            Some(source.bytes.clone())
        }
        Err(unreadable) => return (None, unreadable),
    };
    (list.filter(|_| !report.has_errors()), report)
}

fn of_set(
    source: &Arc<Source>,
    path: &Path,
    axis: Option<&str>,
    load: Load<'_>,
    report: &mut Report,
) -> Option<Vec<u8>> {
    let table = set::parse(source, report)?;
    let (top, axes) = set::top(source, table.get_ref(), report);
    let axis = named(source, &axes, axis, report)?;
    let keys = set::values_of(source, axis, report);
    if report.has_errors() {
        return None;
    }
    let Some(list) = given::list_of(&keys, path, load) else {
        let base = imported(&keys).map_err(|refused| report.extend(refused)).ok()?;
        return Filling { values: top.overridden_by(keys), report }.list(base.as_deref());
    };
    let list = list.map_err(|unreadable| report.extend(unreadable)).ok()?;
    let read = list::read_to_keep(&list);
    report.extend(read.report);
    // Their lines stay as they are.
    report.diagnostics.extend(read.values.unread(&Report::default()));
    if report.has_errors() {
        return None;
    }
    Filling { values: read.values.overridden_by(keys), report }.list(Some(&list.bytes))
}

fn named<'a>(
    source: &Source,
    axes: &[AxisTable<'a>],
    name: Option<&str>,
    report: &mut Report,
) -> Option<AxisTable<'a>> {
    let found = match (name, axes) {
        (None, [axis]) => return Some(*axis),
        // That has been said.
        (_, []) => return None,
        (None, _) => "the set has several axes".to_owned(),
        (Some(name), _) => match axes.iter().find(|axis| axis.name == name) {
            Some(axis) => return Some(*axis),
            None => format!("the set has no axis {}", shown(name)),
        },
    };
    let names = axes.iter().map(|axis| axis.name).collect::<Vec<_>>().join(", ");
    let said = Diagnostic::error(codes::NO_AXIS, source.whole(), found);
    report.push(said.allowed(format!("--axis with one of {names}")));
    None
}

/// The lines of the list that the axis was imported from, if it was.
fn imported(keys: &Values) -> Result<Option<Vec<u8>>, Report> {
    let Some((text, setting)) = keys.text(Name::ImportedLines) else { return Ok(None) };
    // An editor, or a version control, may have saved the whole set with other line ends.
    let is_saved = setting.source.bytes[setting.value_at..].starts_with(b"\"\"\"\r\n");
    let text = if is_saved { text.replace("\r\n", "\n") } else { text.to_owned() };
    let latin_1 = keys.word(Name::ImportedEncoding) == Some(ListEncoding::Latin1);
    let crlf = keys.word(Name::ImportedLineEnd) == Some(LineEnd::CrLf);
    Encoded { text, latin_1, crlf }.bytes().map(Some).map_err(|character| {
        let found = format!("the lines have the character {character:?}, which is none of latin-1");
        let said = Diagnostic::error(codes::BYTE, setting.value_place(), found);
        Report::from(said.allowed("characters up to U+00FF, or another encoding"))
    })
}
