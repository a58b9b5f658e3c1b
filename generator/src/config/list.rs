//! Reading an axis list: `path value` lines, comments, bytes. No default, no range, no rule, no file access.
//!
//! A `#`, or a `(` at the start of a line or behind a blank, begins a comment, in which every byte is legal.

use super::closest;
use super::path::{self, Path};
use super::source::Source;
use super::value::{self, Refused};
use super::values::{Setting, Values};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::{Name, Scope, Value, path_with};
use std::io::BufRead;

/// What an axis list holds.
#[derive(Debug)]
pub struct List<'a> {
    /// the parameters that are in the table
    pub values: Values<'a>,
    /// how many others were passed over
    pub foreign: usize,
    /// what is to be said
    pub report: Report,
    /// false: it is another kind of file, and was not read to its end
    pub complete: bool,
}

/// So many lines that are no lines of a list make it another kind of file: the rest is not read.
const UNREADABLE_LINES: usize = 20;

/// Reads an axis list.
#[must_use]
pub fn read<'a>(source: &'a Source<'a>) -> List<'a> {
    let mut list = List { values: Values::default(), foreign: 0, report: Report::default(), complete: true };
    let mut unreadable = 0;
    // Some editors put a byte order mark before the text.
    let mut next = if source.bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 };
    while next < source.bytes.len() {
        let start = next;
        // Reading from memory cannot fail; of the standard library's ways to the next line this is the fastest.
        next += (&source.bytes[start..]).skip_until(b'\n').unwrap_or(source.bytes.len() - start);
        let line = &source.bytes[start..next];
        match statement(line.strip_suffix(b"\n").unwrap_or(line)) {
            Ok(None) => {}
            Ok(Some(statement)) => {
                if list.take(source, start, &statement) {
                    continue;
                }
                unreadable += 1;
            }
            Err(at) => {
                list.report.push(bad_byte(source, start + at));
                unreadable += 1;
            }
        }
        if unreadable == UNREADABLE_LINES {
            let found = format!("{UNREADABLE_LINES} lines that no axis list has; the rest is not read");
            list.report
                .push(Diagnostic::error(codes::NO_LIST, source.whole(), found).instead("the name of an axis list"));
            list.complete = false;
            break;
        }
    }
    list
}

/// A line without its comment.
#[derive(Debug, PartialEq, Eq)]
struct Statement<'l> {
    path: &'l str,
    path_at: usize,
    /// empty if there is none
    value: &'l str,
    value_at: usize,
}

/// The bytes that neither begin a comment nor are illegal outside of one. A list is mostly these.
static PLAIN: [bool; 256] = {
    let mut plain = [false; 256];
    let mut byte = b' ';
    while byte <= b'~' {
        plain[byte as usize] = byte != b'#' && byte != b'(';
        byte += 1;
    }
    plain[b'\t' as usize] = true;
    plain
};

/// What a line says; or where it has a byte that is legal in a comment only.
fn statement(line: &[u8]) -> Result<Option<Statement<'_>>, usize> {
    let is_blank = |byte: &u8| matches!(byte, b' ' | b'\t');
    let line = line.strip_suffix(b"\r").unwrap_or(line);
    let mut end = 0;
    loop {
        end += line[end..].iter().position(|byte| !PLAIN[usize::from(*byte)]).unwrap_or(line.len() - end);
        match line.get(end) {
            None | Some(b'#') => break,
            Some(b'(') if end == 0 || is_blank(&line[end - 1]) => break,
            Some(b'(') => end += 1,
            Some(_) => return Err(end),
        }
    }
    let Ok(text) = str::from_utf8(&line[..end]) else { return Err(0) };
    let text = text.trim_ascii_end();
    let path_at = text.len() - text.trim_ascii_start().len();
    if path_at == text.len() {
        return Ok(None);
    }
    let path_end =
        text.bytes().skip(path_at).position(|byte| is_blank(&byte)).map_or(text.len(), |length| path_at + length);
    let value = text[path_end..].trim_ascii_start();
    Ok(Some(Statement { path: &text[path_at..path_end], path_at, value, value_at: text.len() - value.len() }))
}

impl<'a> List<'a> {
    /// Takes what a line says; false if it is no line of a list.
    fn take(&mut self, source: &'a Source<'a>, start: usize, statement: &Statement<'_>) -> bool {
        let &Statement { path: written, path_at, value, value_at } = statement;
        let place = || source.place(start + path_at);
        match path::find(written) {
            Path::Known { name, .. } if name.parameter().scope != Scope::List => {
                let found = format!("`{written}` is a key of an axis set; no axis list has it");
                self.report.push(Diagnostic::error(codes::KEY_OF_A_SET, place(), found).instead(instead_of_key(name)));
            }
            Path::Known { name, index, spelling, misprint } => {
                if misprint {
                    let found = format!("`{written}` is a misprint of the manual");
                    let instead = path_with(name.parameter().path, index);
                    self.report.push(Diagnostic::warning(codes::MISPRINT, place(), found).instead(instead));
                }
                let value = match value_of(name, statement) {
                    Ok(value) => Some(value),
                    Err(refused) => {
                        self.report.push(refused.diagnostic(name, written, source.place(start + value_at)));
                        None
                    }
                };
                let setting = Setting { value, spelling, source, path_at: start + path_at, value_at: start + value_at };
                if let Some(first) = self.values.insert((name, index), setting) {
                    let found = format!("`{written}` is given twice, first in line {}", first.path_place().line);
                    let instead = "one of the two lines";
                    self.report.push(Diagnostic::error(codes::GIVEN_TWICE, place(), found).instead(instead));
                }
            }
            Path::OutOfRange { name, .. } => self.report.push(out_of_range(name, written, place())),
            Path::Foreign if !closest::is_ours(written) => self.foreign += 1,
            Path::Foreign => match closest::path(written) {
                Some(known) => {
                    let found = format!("{} is not known", value::shown(written));
                    self.report.push(Diagnostic::error(codes::UNKNOWN, place(), found).instead(known));
                }
                None => {
                    self.foreign += 1;
                    let found = format!("{} is not known, and passed over", value::shown(written));
                    self.report.push(Diagnostic::warning(codes::PASSED_OVER, place(), found));
                }
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

/// The value of a parameter that stands in a line.
fn value_of(name: Name, statement: &Statement<'_>) -> Result<Value, Refused> {
    let parameter = name.parameter();
    let &Statement { path, value: text, .. } = statement;
    let refused = |code, found, instead| Err(Refused { code, found, allowed: parameter.allowed(), instead });
    if text.is_empty() {
        refused(codes::NO_VALUE, "has no value".to_owned(), None)
    } else if let Some(rest) = text.strip_prefix('=') {
        let instead = Some(format!("{path} {}", rest.trim_ascii_start()));
        refused(codes::LINE, format!("is {}: a list has no `=`", value::shown(text)), instead)
    } else if text.contains([' ', '\t']) {
        refused(codes::LINE, format!("is {}: more than one value", value::shown(text)), None)
    } else {
        value::of_text(parameter, text)
    }
}

/// An index that the parameter does not have.
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

fn bad_byte(source: &Source<'_>, at: usize) -> Diagnostic {
    let found = format!("byte 0x{:02X} outside of a comment", source.bytes[at]);
    Diagnostic::error(codes::BYTE, source.place(at), found)
        .allowed("printable ASCII and tabs; any byte in a comment")
        .instead("the line without it, or a `#` before the comment")
}

fn instead_of_key(name: Name) -> String {
    match name {
        Name::CycleTime => "the option --cycle-time".to_owned(),
        _ => format!("`{}` in a TOML set whose axis names this list", name.parameter().short()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(line: &str) -> Option<(&str, &str)> {
        statement(line.as_bytes()).unwrap().map(|statement| (statement.path, statement.value))
    }

    #[test]
    fn statements_and_comments() {
        assert_eq!(parts("a.b 1"), Some(("a.b", "1")));
        assert_eq!(parts(" \ta.b\t 1 \t\r"), Some(("a.b", "1")));
        assert_eq!(parts("a.b 1#c"), Some(("a.b", "1")));
        assert_eq!(parts("a.b\t1\t( P-AXIS-00001 : x"), Some(("a.b", "1")));
        assert_eq!(parts("a.b"), Some(("a.b", "")));
        assert_eq!(parts("a.b VEL ACC"), Some(("a.b", "VEL ACC")));
        for comment in ["", "  ", "\r", "# a 1", "(a 1", "  ( a", "#\u{e4}"] {
            assert_eq!(parts(comment), None, "{comment:?}");
        }
    }

    #[test]
    fn bytes_that_only_a_comment_may_have() {
        assert_eq!(statement(b"a \xE4"), Err(2));
        assert_eq!(statement(b"a\0 1"), Err(1));
        assert_eq!(statement(b"a 1\r#"), Err(3));
        assert_eq!(statement(b"a 1 # \xE4\0").unwrap().unwrap().value, "1");
        assert_eq!(statement(b"a 1 (\xB0").unwrap().unwrap().value, "1");
    }
}
