//! Reads the lines of an axis list. No default, no range, no rule, no file access; `lines.rs` splits the lines.

use super::lines::{self, Content, Lines, Statement};
use super::other_functions::OtherFunctions;
use super::path::{self, Path};
use super::project::AxisList;
use super::value::{self, Refused};
use super::values::{Key, Setting, Values};
use super::{closest, odd_line, own_key, source::Source};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::{Kind, Name, Parameter, Scope, Value, path_with};
use std::sync::Arc;

pub(crate) struct List {
    /// the parameters that are in the table
    pub(crate) values: Values,
    /// axgen's own keys, in comments
    pub(crate) own: Values,
    pub(crate) foreign: OtherFunctions,
    pub(crate) report: Report,
    /// false if it is another kind of file, and was not read to its end
    pub(crate) complete: bool,
}

/// After this number of unreadable lines it is another kind of file: the rest is not read.
const UNREADABLE_LINES: usize = 20;

pub(crate) fn read(list: &AxisList) -> List {
    let mut reading = Reading {
        list: List {
            values: Values::default(),
            own: Values::default(),
            foreign: OtherFunctions::default(),
            report: list.said.clone().map(Report::from).unwrap_or_default(),
            complete: true,
        },
        source: &list.source,
        commented: None,
        is_open: false,
        is_after_end: false,
        is_taken: false,
    };
    let mut unreadable = 0;
    let mut lines = lines::split(list.bytes()).1;
    while let Some(line) = lines.next() {
        unreadable += usize::from(!reading.line(list.range.start + line.at, line.content, &lines));
        if unreadable == UNREADABLE_LINES {
            let found = format!("{UNREADABLE_LINES} lines that no axis list has; the rest is not read");
            let said = Diagnostic::error(codes::NO_LIST, list.place(), found);
            reading.list.report.push(said.instead("the name of an axis list"));
            reading.list.complete = false;
            break;
        }
    }
    reading.list
}

struct Reading<'s> {
    list: List,
    source: &'s Arc<Source>,
    /// the last line ended with a comment; the value is whether a continuation without a comment sign has been reported
    commented: Option<bool>,
    /// the last comment `/*` has no `*/` in its line
    is_open: bool,
    is_after_end: bool,
    /// the line was the value of the line above, which has been reported
    is_taken: bool,
}

impl Reading<'_> {
    /// Reads a line with the lines below it; false if it is not a line of a list.
    fn line(&mut self, at: usize, content: Content<'_>, below: &Lines<'_>) -> bool {
        if std::mem::take(&mut self.is_taken) {
            return true;
        }
        let (comment, comment_at) = match content {
            Content::Remark { indent, comment } => (comment, at + indent.len()),
            Content::Statement(statement) => (statement.comment, at + statement.comment_at()),
            Content::Unreadable { .. } => (&[][..], at),
        };
        self.comment(comment_at, comment);
        let commented = self.commented.take();
        self.commented = (!comment.is_empty()).then_some(false);
        match content {
            Content::Remark { .. } => {
                self.own_key(comment_at, comment);
                true
            }
            Content::Statement(statement) if statement.is_end() => {
                self.is_after_end = true;
                true
            }
            Content::Statement(line) if self.is_open && !self.is_after_end && odd_line::ends_no_comment(&line) => {
                self.list.report.push(end_of_no_comment(self.source.place(at + line.path_at())));
                self.is_open = false;
                false
            }
            Content::Statement(statement) if commented.is_some() && odd_line::is_prose(&statement) => {
                self.wrapped(at, &statement, commented == Some(true));
                true
            }
            Content::Statement(statement) => self.statement(at, &statement, below),
            Content::Unreadable { text, at: bad } => {
                // A name or a text of another function may be Latin-1 or UTF-8.
                let is_kept = text[bad] >= 0x80
                    && !(self.is_open && text.trim_ascii_end().ends_with(b"*/"))
                    && odd_line::is_of_another_function(&text[..bad]);
                self.list.foreign.count += usize::from(is_kept);
                if !is_kept {
                    self.meant(at, str::from_utf8(text[..bad].trim_ascii_start()).unwrap_or_default());
                    self.list.report.push(bad_byte(self.source, at + bad));
                }
                is_kept
            }
        }
    }

    /// Reports text after a comment `/* ... */`, and a comment `/*` that ends within the comment of a later line.
    fn comment(&mut self, at: usize, comment: &[u8]) {
        if let Some(after) = odd_line::text_after(comment) {
            self.list.report.push(after_comment(self.source, at + after));
        }
        let begins = comment.starts_with(b"/*");
        if begins || self.is_open {
            self.is_open = !comment.windows(2).any(|two| two == b"*/");
            if !begins && !self.is_open {
                self.list.report.push(end_of_no_comment(self.source.place(at)));
            }
        }
    }

    /// A comment with one of axgen's own keys.
    fn own_key(&mut self, at: usize, comment: &[u8]) {
        let Some(own) = own_key::in_comment(comment) else { return };
        let (source, [path_at, value_at]) = (self.source, [at + own.path_at, at + own.text_at]);
        if let Path::OutOfRange { name, .. } = path::find(own.path) {
            self.list.report.push(out_of_range(name, own.path, source.place(path_at)));
            return;
        }
        match own.read([path_at, value_at].map(|at| source.place(at))) {
            Ok((key, spelling, value)) => {
                let source = Arc::clone(source);
                let setting = Setting { value: Some(value), refused: None, spelling, source, path_at, value_at };
                if let Some(first) = self.list.own.insert(key, setting) {
                    self.list.report.push(twice(own.path, first, self.source.place(path_at)));
                }
            }
            Err(said) => self.list.report.extend(said),
        }
    }

    /// A line that continues the comment of the line above, as printed in manuals, without a comment sign.
    fn wrapped(&mut self, at: usize, statement: &Statement<'_>, is_said: bool) {
        self.commented = Some(true);
        if !is_said {
            let place = self.source.place(at + statement.path_at());
            let found = "the line continues the comment above, and has no sign of a comment".to_owned();
            let instead = format!("# {} {}", statement.path, statement.value);
            self.list.report.push(Diagnostic::warning(codes::WRAPPED, place, found).instead(instead.trim_ascii_end()));
        }
    }

    /// A line with a path.
    fn statement(&mut self, at: usize, statement: &Statement<'_>, below: &Lines<'_>) -> bool {
        let place = || self.source.place(at + statement.path_at());
        let path = path::find(statement.path);
        if self.is_after_end {
            if matches!(path, Path::Known { .. }) {
                let found = format!("`{}` comes after `Ende`, where the list ends", statement.path);
                let said = Diagnostic::error(codes::BEHIND_END, place(), found);
                self.list.report.push(said.instead("the line before `Ende`"));
            }
            return true;
        }
        if let Some(input) = odd_line::nc_word(statement.path) {
            let found = format!("{} is a word of an NC program; no axis list has it", value::shown(statement.path));
            let instead = format!("the input `{input}` of the block feedforward, or axis, at run time");
            self.list.report.push(Diagnostic::error(codes::NC_WORD, place(), found).instead(instead));
            return true;
        }
        if let Some((found, instead)) = odd_line::value_below(statement, below) {
            let said = Diagnostic::error(codes::NO_VALUE, place(), found).allowed("path and value in one line");
            self.meant(at, &instead);
            self.list.report.push(said.instead(instead));
            self.is_taken = true;
            return true;
        }
        self.take(at, statement, path)
    }

    /// Takes the contents of a line; false if it is not a line of a list.
    fn take(&mut self, start: usize, statement: &Statement<'_>, path: Path<'_>) -> bool {
        let (written, source) = (statement.path, self.source);
        let place = || source.place(start + statement.path_at());
        let error = |code, found: String| Diagnostic::error(code, place(), found);
        let said = match path {
            Path::Known { name, index, .. } if name.parameter().scope != Scope::List => {
                let found = format!("`{written}` is a key of an axis set; no axis list has it");
                error(codes::KEY_OF_A_SET, found).instead(instead_of_key(name, index))
            }
            Path::Known { name, index, spelling, .. } => {
                self.give(start, statement, (name, index), spelling);
                return true;
            }
            Path::OutOfRange { name, .. } => out_of_range(name, written, place()),
            Path::Foreign { structure, length, last } => {
                match self.foreign(start, statement, structure, (length, last)) {
                    Some(said) => said,
                    None => return true,
                }
            }
            Path::Malformed => {
                let (found, instead) = odd_line::malformed(statement);
                Diagnostic { instead, ..error(codes::LINE, found).allowed("path value # comment") }
            }
        };
        let meant = said.instead.as_deref().filter(|_| said.code == codes::UNKNOWN);
        let said = match meant.map(|meant| path::find(first_word(meant))) {
            Some(Path::OutOfRange { name, .. }) => out_of_range(name, written, place()),
            _ => said,
        };
        if let (codes::UNKNOWN, Some(instead)) = (said.code, &said.instead) {
            self.meant(start + statement.path_at(), instead);
        }
        self.list.report.push(said);
        path != Path::Malformed
    }

    /// The message about a path that is not in the table; `None` for a parameter of another function.
    fn foreign(
        &mut self,
        start: usize,
        statement: &Statement<'_>,
        structure: Option<[&str; 2]>,
        (length, last): (usize, &str),
    ) -> Option<Diagnostic> {
        let (written, source) = (statement.path, self.source);
        let place = || source.place(start + statement.path_at());
        let unknown = |what: &str, instead| {
            let found = format!("{} is {what}", value::shown(written));
            Some(Diagnostic { instead, ..Diagnostic::error(codes::UNKNOWN, place(), found) })
        };
        match path::ending_with(last, written) {
            _ if let Some((what, instead)) = odd_line::joined(statement) => unknown(what, Some(instead)),
            Some(known) => unknown("not known", Some(closest::with_indices_of(known, written))),
            // The usual case, tested first, because comparing letters is slow.
            None if !structure.is_some_and(closest::is_ours) => {
                self.of_another_function(start, statement, structure, (length, last))
            }
            None if path::is_structure(written) => {
                unknown("a structure: its parameters have values", closest::first_below(written))
            }
            None => match closest::path(written, false) {
                Some(known) => unknown("not known", Some(known)),
                None => {
                    self.list.foreign.pass_over(statement, last, source, start);
                    let found = format!("{} is not known, and passed over", value::shown(written));
                    Some(Diagnostic::warning(codes::PASSED_OVER, place(), found))
                }
            },
        }
    }

    /// Passes over a parameter of another function; the message if the line is probably a comment.
    fn of_another_function(
        &mut self,
        start: usize,
        statement: &Statement<'_>,
        structure: Option<[&str; 2]>,
        (length, last): (usize, &str),
    ) -> Option<Diagnostic> {
        let (path, value, source) = (statement.path, statement.value, self.source);
        let place = || source.place(start + statement.path_at());
        self.list.foreign.pass_over(statement, last, source, start);
        let mut known = closest::nearly(path, length, last);
        known.extend(structure.and_then(|structure| closest::below_another(path, structure)));
        if !known.is_empty() {
            self.list.foreign.nearly.push((path.to_owned(), known, place()));
        }
        let is_prose = structure.is_none() && value.contains(' ') && !value.starts_with('=');
        let found = "words without the sign of a comment: no parameter has such a path";
        let said = || Diagnostic::warning(codes::WRAPPED, place(), found).instead(format!("# {path} {value}"));
        is_prose.then(said)
    }

    /// The parameter that a wrong line was meant to give is not missing: that would be a second message about one mistake.
    fn meant(&mut self, at: usize, instead: &str) {
        let Path::Known { name, index, spelling, .. } = path::find(first_word(instead)) else { return };
        let source = Arc::clone(self.source);
        let setting = Setting { value: None, refused: None, spelling, source, path_at: at, value_at: at };
        if self.list.values.get((name, index)).is_none() {
            self.list.values.insert((name, index), setting);
        }
    }

    /// Takes the value of a parameter.
    fn give(&mut self, start: usize, line: &Statement<'_>, key: Key, spelling: &'static str) {
        let source = self.source;
        let (written, parameter) = (line.path, key.0.parameter());
        let spelled = value::spelled(parameter, line.value);
        let (path_at, value_at) = (start + line.path_at(), start + line.value_at() + spelled.at);
        if !spelled.after.is_empty() {
            let place = source.place(start + line.value_at() + spelled.after_at);
            let unit = if parameter.unit.is_empty() { String::new() } else { format!(" [{}]", parameter.unit) };
            let (text, after) = (value::shown(spelled.text), value::shown(spelled.after));
            let found = format!("a controller takes {after} for a comment: the value is {text}{unit}");
            let said = Diagnostic::warning(codes::TEXT_BEHIND, place, found);
            self.list.report.push(said.instead(format!("{written} {} # {}", spelled.text, spelled.after)));
        }
        if parameter.misprints.contains(&spelling) {
            let found = format!("`{written}` is a misprint of the manual");
            let said = Diagnostic::warning(codes::MISPRINT, source.place(path_at), found);
            self.list.report.push(said.instead(path_with(parameter.path, key.1)));
        }
        let mut setting =
            Setting { value: None, refused: None, spelling, source: Arc::clone(source), path_at, value_at };
        let with_radix =
            value::with_radix(parameter, line.value.as_bytes(), line.comment).filter(|_| line.space.is_empty());
        match with_radix.map_or_else(|| value_of(parameter, written, spelled.text), Err) {
            Ok(value) => setting.value = Some(value),
            Err(refused) => {
                let refused = refused.diagnostic(key.0, written, setting.value_place());
                // `=` begins a placeholder of `import`, which is never a value of another function.
                if parameter.is_shared && !spelled.text.starts_with('=') {
                    // Reported where the value is used.
                    setting.refused = Some(refused);
                } else {
                    self.list.report.push(refused);
                }
            }
        }
        if let Some(first) = self.list.values.insert(key, setting) {
            self.list.report.push(twice(written, first, source.place(path_at)));
        }
    }
}

/// The path at the start of what is advised.
fn first_word(instead: &str) -> &str {
    &instead[..value::end_of_word(instead)]
}

fn twice(written: &str, first: &Setting, place: Place) -> Diagnostic {
    let found = format!("`{written}` is given twice, first in line {}", first.path_place().line);
    Diagnostic::error(codes::GIVEN_TWICE, place, found).instead("one of the two lines")
}

fn end_of_no_comment(place: Place) -> Diagnostic {
    let found = "`*/` ends no comment: a comment ends with its line, and the lines between were read";
    let said = Diagnostic::error(codes::LINE, place, found).allowed("path value # comment");
    said.instead("a `#` before each line of the comment")
}

fn after_comment(source: &Source, at: usize) -> Diagnostic {
    let found = "text after `*/`: a comment ends with its line, and the controller does not read the text";
    let said = Diagnostic::error(codes::COMMENT, source.place(at), found);
    said.allowed("a comment to the end of the line").instead("the text in a line of its own")
}

fn value_of(parameter: &Parameter, path: &str, text: &str) -> Result<Value, Refused> {
    let refused = |code, found, instead| Err(Refused { code, found, allowed: parameter.allowed(), instead });
    if text.is_empty() {
        refused(codes::NO_VALUE, "has no value".to_owned(), None)
    } else if let Some(rest) = text.strip_prefix('=') {
        let instead = Some(format!("{path} {}", rest.trim_ascii_start()));
        refused(codes::LINE, format!("is {}: a list has no `=`", value::shown(text)), instead)
    } else if text.contains([' ', '\t']) && !matches!(parameter.kind, Kind::Flags(_)) {
        let found = format!("is {}: more than one value", value::shown(text));
        refused(codes::LINE, found, value::meant_number(parameter, text))
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
    let (what, instead) = odd_line::bad_character(&source.bytes[at..]);
    let said = Diagnostic::error(codes::BYTE, source.place(at), format!("{what} outside of a comment"));
    said.allowed("printable ASCII and tabs; any byte in a comment").instead(instead)
}

fn instead_of_key(name: Name, index: [u32; 2]) -> String {
    match name {
        Name::CycleTime => "the option --cycle-time".to_owned(),
        _ => format!("`{}` in a TOML set whose axis names this list", path_with(name.parameter().path, index)),
    }
}
