//! Reading an axis list: what its lines say. No default, no range, no rule, no file access; `lines.rs` splits the lines.

use super::lines::{self, Content, Statement};
use super::path::{self, Path};
use super::value::{self, Refused};
use super::values::{Key, Setting, Values};
use super::{closest, source::Source};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::{Kind, Name, Parameter, Scope, Value, path_with};
use std::sync::Arc;

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
    read_lines(source, |_| false)
}

/// The same for a list whose lines are kept as they are: in the line of a parameter of another function a byte that only a
/// comment may have is a warning.
pub(crate) fn read_to_keep(source: &Arc<Source>) -> List {
    read_lines(source, |before| {
        let before = before.trim_ascii_start();
        let end = before.iter().position(|byte| matches!(byte, b' ' | b'\t'));
        let path = end.and_then(|end| str::from_utf8(&before[..end]).ok());
        path.is_some_and(|path| {
            path::find(path) == Path::Foreign && !closest::is_ours(path) && path::with_other_indices(path).is_none()
        })
    })
}

/// Reads a list; `is_tolerated` tells whether a line may have a bad byte behind these.
fn read_lines(source: &Arc<Source>, is_tolerated: impl Fn(&[u8]) -> bool) -> List {
    let mut list = List { values: Values::default(), foreign: 0, report: Report::default(), complete: true };
    let mut unreadable = 0;
    for line in lines::split(&source.bytes).1 {
        let is_readable = match line.content {
            Content::Remark { .. } => true,
            Content::Statement(statement) => list.take(source, line.at, &statement),
            Content::Unreadable { text, at } => {
                let said = bad_byte(source, line.at + at);
                let is_foreign = is_tolerated(&text[..at]);
                list.foreign += usize::from(is_foreign);
                list.report.push(match is_foreign {
                    true => Diagnostic::warning(codes::BYTE, said.place, said.found),
                    false => said,
                });
                is_foreign
            }
        };
        unreadable += usize::from(!is_readable);
        if unreadable == UNREADABLE_LINES {
            let found = format!("{UNREADABLE_LINES} lines that no axis list has; the rest is not read");
            let said = Diagnostic::error(codes::NO_LIST, source.whole(), found);
            list.report.push(said.instead("the name of an axis list"));
            list.complete = false;
            break;
        }
    }
    list
}

impl List {
    /// Takes what a line says; false if it is no line of a list.
    fn take(&mut self, source: &Arc<Source>, start: usize, statement: &Statement<'_>) -> bool {
        let written = statement.path;
        let place = || source.place(start + statement.path_at());
        let error = |code, found: String| Diagnostic::error(code, place(), found);
        let unknown = |what: &str, instead| {
            let found = format!("{} is {what}", value::shown(written));
            Diagnostic { instead, ..error(codes::UNKNOWN, found) }
        };
        let path = path::find(written);
        let said = match path {
            Path::Known { name, index, .. } if name.parameter().scope != Scope::List => {
                let found = format!("`{written}` is a key of an axis set; no axis list has it");
                error(codes::KEY_OF_A_SET, found).instead(instead_of_key(name, index))
            }
            Path::Known { name, index, spelling, .. } => {
                self.give(source, start, statement, (name, index), spelling);
                return true;
            }
            Path::OutOfRange { name, .. } => out_of_range(name, written, place()),
            Path::Foreign => match path::with_other_indices(written) {
                _ if let Some(instead) = with_underscores(statement) => {
                    unknown("not known: its name has `_` where the line has blanks", Some(instead))
                }
                Some(known) => unknown("not known", Some(closest::with_indices_of(known, written))),
                // Mostly so, and asked once: comparing letters takes its time.
                None if !closest::is_ours(written) => {
                    self.foreign += 1;
                    return true;
                }
                None if path::is_structure(written) => {
                    unknown("a structure: its parameters have values", closest::first_below(written))
                }
                None => match closest::path(written, false) {
                    Some(known) => unknown("not known", Some(known)),
                    None => {
                        self.foreign += 1;
                        let found = format!("{} is not known, and passed over", value::shown(written));
                        Diagnostic::warning(codes::PASSED_OVER, place(), found)
                    }
                },
            },
            Path::Malformed => {
                let found = format!("{} is no path", value::shown(written));
                let has_equals = written.contains('=') || statement.value.starts_with('=');
                let instead = has_equals.then(|| "the same without `=`".to_owned());
                Diagnostic { instead, ..error(codes::LINE, found).allowed("path value # comment") }
            }
        };
        self.report.push(said);
        path != Path::Malformed
    }

    /// Takes the value of a parameter.
    fn give(&mut self, source: &Arc<Source>, start: usize, line: &Statement<'_>, key: Key, spelling: &'static str) {
        let (written, parameter) = (line.path, key.0.parameter());
        let (path_at, value_at) = (start + line.path_at(), start + line.value_at());
        if parameter.misprints.contains(&spelling) {
            let found = format!("`{written}` is a misprint of the manual");
            let said = Diagnostic::warning(codes::MISPRINT, source.place(path_at), found);
            self.report.push(said.instead(path_with(parameter.path, key.1)));
        }
        let mut setting =
            Setting { value: None, refused: None, spelling, source: Arc::clone(source), path_at, value_at };
        match value_of(parameter, line) {
            Ok(value) => setting.value = Some(value),
            Err(refused) => {
                let refused = refused.diagnostic(key.0, written, setting.value_place());
                // `=` begins what `import` leaves in the place of a value: it is never one of another function's.
                if parameter.is_shared && !line.value.starts_with('=') {
                    // Said where something uses it.
                    setting.refused = Some(refused);
                } else {
                    self.report.push(refused);
                }
            }
        }
        if let Some(first) = self.values.insert(key, setting) {
            let found = format!("`{written}` is given twice, first in line {}", first.path_place().line);
            let said = Diagnostic::error(codes::GIVEN_TWICE, source.place(path_at), found);
            self.report.push(said.instead("one of the two lines"));
        }
    }
}

/// A line whose path has blanks where underscores belong, with underscores: `weight fact denom 200`.
fn with_underscores(line: &Statement<'_>) -> Option<String> {
    // A number after the path is its value; no name of ours is as long as the bound, which keeps a long line cheap.
    let is_word = |text: &str| text.starts_with(|letter: char| letter.is_ascii_alphabetic());
    let (mut path, mut rest) = (if is_word(line.value) { line.path.to_owned() } else { return None }, line.value);
    while path.len() < 128 && is_word(rest) {
        let word = &rest[..rest.find([' ', '\t']).unwrap_or(rest.len())];
        rest = rest[word.len()..].trim_ascii_start();
        path.extend(["_", word]);
        if matches!(path::find(&path), Path::Known { .. }) {
            return Some(format!("{path} {rest}").trim_ascii_end().to_owned());
        }
    }
    None
}

fn value_of(parameter: &Parameter, &Statement { path, value: text, .. }: &Statement<'_>) -> Result<Value, Refused> {
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
    let letters = parameter.path.split('[').skip(1).map(|rest| &rest[..1]);
    let sizes = letters.zip(parameter.indices).map(|(letter, size)| format!("0 <= {letter} <= {}", size - 1));
    Diagnostic::error(codes::INDEX, place, format!("{} has an index that does not exist", value::shown(written)))
        .allowed(format!("{} with {}", parameter.path, sizes.collect::<Vec<_>>().join(", ")))
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
