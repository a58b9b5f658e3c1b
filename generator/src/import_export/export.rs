//! An axis of a set as an axis list: its original lines, and its present values. No line is written here.

use super::fill::Filling;
use crate::config::{AxisTable, Encoding, Load, Source, Values, file, given, list, project, set, shown};
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::words::{LineEnd, ListEncoding};
use crate::{codes, parameters::Name};
use std::{path::Path, sync::Arc};

/// An axis of a TOML set (`.toml`) as an axis list; without a name the only axis. An axis list (any other extension) is
/// returned unchanged. The list is `Some` if and only if no message is an error. Rules between parameters are not checked.
pub fn export(path: &Path, axis: Option<&str>, load: Load<'_>) -> (Option<Vec<u8>>, Report) {
    let mut report = Report::default();
    let list = match file::read(path, None, load) {
        Ok(source) if file::is_set(path) => of_set(&source, path, axis, load, &mut report),
        Ok(source) => as_it_is(&source, &mut report),
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
    let Some(list) = given::list_of(&keys, axis.name, path, load) else {
        let base = imported(&keys).map_err(|refused| report.extend(refused)).ok()?;
        let filling = Filling { values: top.overridden_by(keys), report };
        let Some(Imported { text: [before, lines, after], encoding, place }) = base else { return filling.list(None) };
        let list = filling.list(Some(&lines))?;
        return file_of([&before, &list, &after], encoding, &place, report);
    };
    let list = list.map_err(|unreadable| report.extend(unreadable)).ok()?;
    if list.source.is_converted() {
        let found = "the list is an axis of TwinCAT NC, into which nothing can be written";
        let said = Diagnostic::error(codes::PROJECT, list.source.whole(), found);
        report.push(said.instead("the values in the NC's own dialogs; `axgen import` makes a set of the axis"));
        return None;
    }
    let read = list::read(&list);
    report.extend(read.report);
    // Lines with unreadable values stay unchanged.
    report.diagnostics.extend(read.values.unread(&Report::default()));
    if report.has_errors() {
        return None;
    }
    let filled = Filling { values: read.values.overridden_by(keys), report }.list(Some(list.bytes()))?;
    let [before, after] = list.around();
    file_of([before, &filled, after], list.source.encoding, &list.source.whole(), report)
}

/// The bytes of a list or a project, if its lists can be read.
fn as_it_is(source: &Arc<Source>, report: &mut Report) -> Option<Vec<u8>> {
    let lists = project::lists(source).map_err(|refused| report.extend(refused)).ok()?;
    for list in lists {
        report.extend(list::read(&list).report);
    }
    file_of([&source.bytes, b"", b""], source.encoding, &source.whole(), report)
}

fn named<'a>(
    source: &Source,
    axes: &[AxisTable<'a>],
    name: Option<&str>,
    report: &mut Report,
) -> Option<AxisTable<'a>> {
    let found = match (name, axes) {
        (None, [axis]) => return Some(*axis),
        // Already reported.
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

/// The file that an axis was imported from: the text before its list, the list, and the text after it.
struct Imported {
    text: [Vec<u8>; 3],
    encoding: Encoding,
    place: Place,
}

fn imported(keys: &Values) -> Result<Option<Imported>, Report> {
    let Some((_, setting)) = keys.text(Name::ImportedLines) else { return Ok(None) };
    let place = setting.value_place();
    // An editor or version control may have changed the line ends of the whole set.
    let is_saved = setting.source.bytes[setting.value_at..].starts_with(b"\"\"\"\r\n");
    let crlf = keys.word(Name::ImportedLineEnd) == Some(LineEnd::CrLf);
    let text = [Name::ImportedBefore, Name::ImportedLines, Name::ImportedAfter].map(|name| {
        let text = keys.text(name).map_or("", |(text, _)| text);
        let text = if is_saved { text.replace("\r\n", "\n") } else { text.to_owned() };
        if crlf { text.replace('\n', "\r\n") } else { text }.into_bytes()
    });
    let encoding = match keys.word(Name::ImportedEncoding).unwrap_or(ListEncoding::Utf8) {
        ListEncoding::Utf8 => Encoding::Plain,
        ListEncoding::Latin1 => {
            let [before, lines, after] = text.map(|text| encoded(text, Encoding::Latin1, &place));
            return Ok(Some(Imported { text: [before?, lines?, after?], encoding: Encoding::Plain, place }));
        }
        ListEncoding::Utf16LittleEnd => Encoding::Utf16LittleEnd,
        ListEncoding::Utf16BigEnd => Encoding::Utf16BigEnd,
    };
    Ok(Some(Imported { text, encoding, place }))
}

fn encoded(text: Vec<u8>, encoding: Encoding, place: &Place) -> Result<Vec<u8>, Report> {
    encoding.encoded(text).map_err(|character| {
        let found = format!("the lines have the character {character:?}, which is none of latin-1");
        let said = Diagnostic::error(codes::BYTE, place.clone(), found);
        said.allowed("characters up to U+00FF, or another encoding").into()
    })
}

/// The bytes of a file with these parts.
fn file_of(parts: [&[u8]; 3], encoding: Encoding, place: &Place, report: &mut Report) -> Option<Vec<u8>> {
    encoded(parts.concat(), encoding, place).map_err(|refused| report.extend(refused)).ok()
}
