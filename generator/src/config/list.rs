//! Reading an axis list: what its lines say. No default, no range, no rule, no file access; `lines.rs` splits the lines.

use super::closest;
use super::lines::{self, Content, Statement};
use super::path::{self, Path};
use super::source::Source;
use super::value::{self, Refused};
use super::values::{Setting, Values};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::{Kind, Name, Scope, Value, path_with};
use std::sync::Arc;

#[derive(Debug)]
pub(crate) struct List {
    /// the parameters that are in the table
    pub(crate) values: Values,
    pub(crate) foreign: usize,
    pub(crate) report: Report,
    /// false: it is another kind of file, and was not read to its end
    pub(crate) complete: bool,
}

/// So many lines that are no lines of a list make it another kind of file: the rest is not read.
const UNREADABLE_LINES: usize = 20;

pub(crate) fn read(source: &Arc<Source>) -> List {
    read_where(source, |_, _| false)
}

/// The same for a list whose lines are kept as they are: in the line of a parameter of another function a byte that only a
/// comment may have is a warning.
pub(crate) fn read_to_keep(source: &Arc<Source>) -> List {
    read_where(source, |text, bad| {
        let text = text[..bad].trim_ascii_start();
        let path = text.iter().position(|byte| matches!(byte, b' ' | b'\t')).map(|end| &text[..end]);
        let path = path.and_then(|path| str::from_utf8(path).ok());
        path.is_some_and(|path| {
            path::find(path) == Path::Foreign && !closest::is_ours(path) && path::with_other_indices(path).is_none()
        })
    })
}

/// Reads a list; `tolerated` tells whether a line may have its bad byte, which is at that place.
fn read_where(source: &Arc<Source>, tolerated: impl Fn(&[u8], usize) -> bool) -> List {
    let mut list = List { values: Values::default(), foreign: 0, report: Report::default(), complete: true };
    let mut unreadable = 0;
    for line in lines::split(&source.bytes).1 {
        let readable = match line.content {
            Content::Remark { .. } => true,
            Content::Statement(statement) => list.take(source, line.at, &statement),
            Content::Unreadable { text, at } if tolerated(text, at) => {
                let Diagnostic { place, found, .. } = bad_byte(source, line.at + at);
                list.report.push(Diagnostic::warning(codes::BYTE, place, found));
                list.foreign += 1;
                true
            }
            Content::Unreadable { at, .. } => {
                list.report.push(bad_byte(source, line.at + at));
                false
            }
        };
        unreadable += usize::from(!readable);
        if !readable && unreadable == UNREADABLE_LINES {
            let found = format!("{UNREADABLE_LINES} lines that no axis list has; the rest is not read");
            list.report
                .push(Diagnostic::error(codes::NO_LIST, source.whole(), found).instead("the name of an axis list"));
            list.complete = false;
            break;
        }
    }
    list
}

impl List {
    /// Takes what a line says; false if it is no line of a list.
    fn take(&mut self, source: &Arc<Source>, start: usize, statement: &Statement<'_>) -> bool {
        let &Statement { path: written, value, .. } = statement;
        let (path_at, value_at) = (statement.path_at(), statement.value_at());
        let place = || source.place(start + path_at);
        let unknown = |what: &str, instead| {
            let found = format!("{} is {what}", value::shown(written));
            Diagnostic { instead, ..Diagnostic::error(codes::UNKNOWN, place(), found) }
        };
        match path::find(written) {
            Path::Known { name, index, .. } if name.parameter().scope != Scope::List => {
                let found = format!("`{written}` is a key of an axis set; no axis list has it");
                self.report
                    .push(Diagnostic::error(codes::KEY_OF_A_SET, place(), found).instead(instead_of_key(name, index)));
            }
            Path::Known { name, index, spelling, misprint } => {
                if misprint {
                    let found = format!("`{written}` is a misprint of the manual");
                    let instead = path_with(name.parameter().path, index);
                    self.report.push(Diagnostic::warning(codes::MISPRINT, place(), found).instead(instead));
                }
                // `=` begins what `import` leaves in the place of a value: it is never one of another function's.
                let can_wait = name.parameter().is_shared && !value.starts_with('=');
                let value = value_of(name, statement)
                    .map_err(|refused| refused.diagnostic(name, written, source.place(start + value_at)));
                let (value, refused) = match value {
                    Ok(value) => (Some(value), None),
                    // Said where something uses it.
                    Err(refused) if can_wait => (None, Some(refused)),
                    Err(refused) => {
                        self.report.push(refused);
                        (None, None)
                    }
                };
                let (path_at, value_at) = (start + path_at, start + value_at);
                let setting = Setting { value, refused, spelling, source: Arc::clone(source), path_at, value_at };
                if let Some(first) = self.values.insert((name, index), setting) {
                    let found = format!("`{written}` is given twice, first in line {}", first.path_place().line);
                    let instead = "one of the two lines";
                    self.report.push(Diagnostic::error(codes::GIVEN_TWICE, place(), found).instead(instead));
                }
            }
            Path::OutOfRange { name, .. } => self.report.push(out_of_range(name, written, place())),
            Path::Foreign => match path::with_other_indices(written) {
                Some(known) => self.report.push(unknown("not known", Some(closest::with_indices_of(known, written)))),
                // Mostly so, and asked once: comparing letters takes its time.
                None if !closest::is_ours(written) => self.foreign += 1,
                None if path::is_structure(written) => {
                    let below = closest::first_below(written);
                    self.report.push(unknown("a structure: its parameters have values", below));
                }
                None => match closest::path(written) {
                    Some(known) => self.report.push(unknown("not known", Some(known))),
                    None => {
                        self.foreign += 1;
                        let found = format!("{} is not known, and passed over", value::shown(written));
                        self.report.push(Diagnostic::warning(codes::PASSED_OVER, place(), found));
                    }
                },
            },
            Path::Malformed => {
                let found = format!("{} is no path", value::shown(written));
                let diagnostic = Diagnostic::error(codes::LINE, place(), found).allowed("path value # comment");
                let equals = written.contains('=') || value.starts_with('=');
                self.report.push(if equals { diagnostic.instead("the same without `=`") } else { diagnostic });
                return false;
            }
        }
        true
    }
}

fn value_of(name: Name, statement: &Statement<'_>) -> Result<Value, Refused> {
    let parameter = name.parameter();
    let &Statement { path, value: text, .. } = statement;
    let refused = |code, found, instead| Err(Refused { code, found, allowed: parameter.allowed(), instead });
    if text.is_empty() {
        refused(codes::NO_VALUE, "has no value".to_owned(), None)
    } else if let Some(rest) = text.strip_prefix('=') {
        let instead = Some(format!("{path} {}", rest.trim_ascii_start()));
        refused(codes::LINE, format!("is {}: a list has no `=`", value::shown(text)), instead)
    } else if text.contains([' ', '\t']) && !matches!(parameter.kind, Kind::Flags(_)) {
        refused(codes::LINE, format!("is {}: more than one value", value::shown(text)), None)
    } else {
        value::of_text(parameter, text)
    }
}

pub(super) fn out_of_range(name: Name, written: &str, place: Place) -> Diagnostic {
    let parameter = name.parameter();
    let sizes: Vec<String> = parameter
        .path
        .split('[')
        .skip(1)
        .zip(parameter.indices)
        .map(|(rest, size)| format!("0 <= {} <= {}", rest.split(']').next().unwrap_or(""), size - 1))
        .collect();
    Diagnostic::error(codes::INDEX, place, format!("{} has an index that does not exist", value::shown(written)))
        .allowed(format!("{} with {}", parameter.path, sizes.join(", ")))
}

fn bad_byte(source: &Source, at: usize) -> Diagnostic {
    let found = format!("byte 0x{:02X} outside of a comment", source.bytes[at]);
    Diagnostic::error(codes::BYTE, source.place(at), found)
        .allowed("printable ASCII and tabs; any byte in a comment")
        .instead("the line without it, or a `#` before the comment")
}

fn instead_of_key(name: Name, index: [u32; 2]) -> String {
    match name {
        Name::CycleTime => "the option --cycle-time".to_owned(),
        _ => format!("`{}` in a TOML set whose axis names this list", path_with(name.parameter().path, index)),
    }
}
