//! An axis of a set as an axis list: which lines it came from, and which values it has now. No line is written here.

use super::encoding::Encoded;
use super::fill::Filling;
use crate::codes;
use crate::config::file::{self, Load};
use crate::config::source::Source;
use crate::config::value::shown;
use crate::config::values::{Setting, Values, key};
use crate::config::{list, set};
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::Name;
use crate::parameters::words::{LineEnd, ListEncoding};
use std::path::Path;

/// An axis of a TOML set (`.toml`) as an axis list; without a name the only one. An axis list (any other extension) is
/// given as it is. The list is there if, and only if, no message is an error. The rules between parameters are not judged.
#[must_use]
pub fn export(path: &Path, axis: Option<&str>) -> (Option<Vec<u8>>, Report) {
    export_with(path, axis, &file::load)
}

/// The same with another source of files.
#[must_use]
pub fn export_with(path: &Path, axis: Option<&str>, load: Load<'_>) -> (Option<Vec<u8>>, Report) {
    let mut report = Report::default();
    let name = path.display().to_string();
    let bytes = match load(path) {
        Ok(bytes) => bytes,
        Err(unreadable) => {
            report.push(unreadable.diagnostic(&name, Place { file: name.clone(), line: 0, column: 0 }));
            return (None, report);
        }
    };
    let source = Source::of(&name, bytes.clone());
    let list = if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) {
        of_set(&source, path, axis, load, &mut report)
    } else {
        report.extend(list::read_to_keep(&source).report);
        Some(bytes.clone())
    };
    (list.filter(|_| !report.has_errors()), report)
}

fn of_set(
    source: &std::sync::Arc<Source>,
    path: &Path,
    axis: Option<&str>,
    load: Load<'_>,
    report: &mut Report,
) -> Option<Vec<u8>> {
    let table = set::parse(source).map_err(|faults| report.extend(faults)).ok()?;
    let top = set::top(source, table.get_ref(), report);
    let axis = named(source, &top.axes, axis, report)?;
    let keys = set::values_of(source, axis, report);
    if report.has_errors() {
        return None;
    }
    let Some(file) = keys.text(Name::List) else {
        let base = imported(&keys, report)?;
        return Filling { values: keys, top: top.values, report }.list(base.as_deref());
    };
    let list_path = path.parent().unwrap_or(Path::new("")).join(file);
    let name = list_path.display().to_string();
    let at = keys.get(key(Name::List)).map_or(source.whole(), Setting::value_place);
    let bytes = load(&list_path).map_err(|unreadable| report.push(unreadable.diagnostic(&name, at))).ok()?;
    let list_source = Source::of(&name, bytes.clone());
    let read = list::read_to_keep(&list_source);
    report.extend(read.report);
    // Their lines stay as they are.
    report.diagnostics.extend(read.values.unread(&Report::default()));
    if report.has_errors() {
        return None;
    }
    let mut values = read.values;
    values.override_with(keys);
    Filling { values, top: Values::default(), report }.list(Some(&bytes))
}

fn named<'a>(
    source: &std::sync::Arc<Source>,
    axes: &[set::AxisTable<'a>],
    name: Option<&str>,
    report: &mut Report,
) -> Option<set::AxisTable<'a>> {
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
    report
        .push(Diagnostic::error(codes::NO_AXIS, source.whole(), found).allowed(format!("--axis with one of {names}")));
    None
}

/// The lines of the list that the axis was imported from, if it was; none within: it was not.
#[expect(clippy::option_option, reason = "outside: whether they can be read; inside: whether there are any")]
fn imported(keys: &Values, report: &mut Report) -> Option<Option<Vec<u8>>> {
    let Some(text) = keys.text(Name::ImportedLines) else { return Some(None) };
    // An editor, or a version control, may have saved the whole set with other line ends.
    let setting = keys.get(key(Name::ImportedLines));
    let is_saved = setting.is_some_and(|at| at.source.bytes[at.value_at..].starts_with(b"\"\"\"\r\n"));
    let text = if is_saved { text.replace("\r\n", "\n") } else { text.to_owned() };
    let latin_1 = keys.word(Name::ImportedEncoding) == Some(ListEncoding::Latin1);
    let crlf = keys.word(Name::ImportedLineEnd) == Some(LineEnd::CrLf);
    let encoded = Encoded { text, latin_1, crlf };
    let refused = |character: char| {
        let place = setting.map(Setting::value_place);
        let place = place.unwrap_or(Place { file: String::new(), line: 0, column: 0 });
        let found = format!("the lines have the character {character:?}, which is none of latin-1");
        report
            .push(Diagnostic::error(codes::BYTE, place, found).allowed("characters up to U+00FF, or another encoding"));
    };
    encoded.bytes().map_err(refused).ok().map(Some)
}
