//! The lines of a list with the present values, and new lines for the values without a line. No file is read here.

use super::slot::{self, HOLE, Slot};
use super::spelling;
use crate::codes;
use crate::config::lines::{self, Content, Line};
use crate::config::own_key::{self, OWN};
use crate::config::{AxisList, Encoding, Key, Setting, Source, Values, key, list, of_text};
use crate::diagnostics::{Diagnostic, Report, Severity};
use crate::parameters::{Name, Scope, Value, path_with};
use std::collections::BTreeSet;

pub(super) struct Filling<'r> {
    /// the values of the axis, including its list, and those at the top of the set
    pub(super) values: Values,
    pub(super) report: &'r mut Report,
}

impl Filling<'_> {
    /// The lines of a list with the present values, then lines for the others; without a list all of them. `None` if the
    /// result has errors, which have been reported.
    pub(super) fn list(mut self, base: Option<&[u8]>) -> Option<Vec<u8>> {
        let bytes = base.unwrap_or_default();
        let (mark, lines) = lines::split(bytes);
        let mut list = mark.to_vec();
        let mut written = BTreeSet::new();
        let (mut line_end, mut end) = (None, None);
        for (line, text) in lines.zip(bytes[mark.len()..].split_inclusive(|byte| *byte == b'\n')) {
            line_end = line_end.or(Some(line.end).filter(|end| end.ends_with(b"\n")));
            let is_end = matches!(line.content, Content::Statement(statement) if statement.is_end());
            end = end.or(is_end.then_some(list.len()));
            let mut text = text.to_vec();
            if let Some(slot) = slot::in_line(&line) {
                self.fill(&line, &slot, &mut written, &mut text);
            }
            list.extend(text);
        }
        let line_end = line_end.unwrap_or(b"\n");
        // A controller ignores everything after `Ende`.
        let after = end.map(|end| list.split_off(end)).unwrap_or_default();
        let mut rest = self.rest(&written, base.is_none());
        if !rest.is_empty() && base.is_some() {
            rest.insert(0, "# Not in the list so far:".to_owned());
            if !list.is_empty() && !list.ends_with(b"\n") {
                // A single return at the end of the file is half of a line end.
                list.extend(if list.ends_with(b"\r") { b"\n" } else { line_end });
            }
        }
        for line in rest {
            list.extend(line.as_bytes());
            list.extend(line_end);
        }
        list.extend(after);
        self.prove(&list);
        (!self.report.has_errors()).then_some(list)
    }

    /// Writes the present value into the text of a line.
    fn fill(&mut self, line: &Line<'_>, slot: &Slot<'_>, written: &mut BTreeSet<Key>, text: &mut Vec<u8>) {
        let parameter = slot.key.0.parameter();
        let range = slot.range.clone();
        let hole = slot.text.strip_prefix(HOLE);
        let spelled = hole.unwrap_or(slot.text);
        if slot.own && written.contains(&slot.key) {
            return;
        }
        let Some((setting, Some(value))) = self.values.get(slot.key).map(|setting| (setting, &setting.value)) else {
            match line.content {
                Content::Statement(statement) if hole.is_none() => self.warn_of(statement.path),
                // The value was removed from the set: so is its line, but not the comment after it.
                Content::Statement(statement) if !statement.comment.is_empty() => {
                    text.drain(statement.path_at()..statement.comment_at());
                }
                _ if hole.is_some() => text.clear(),
                _ => self.warn_of(&path_with(slot.template, slot.key.1)),
            }
            return;
        };
        let read = if slot.own { own_key::value_of(parameter, spelled) } else { of_text(parameter, spelled) };
        if read.as_ref() != Ok(value) {
            text.splice(range, text_of(slot.key, setting, value).bytes());
        } else if hole.is_some() {
            text.splice(range, spelled.bytes());
        }
        written.insert(slot.key);
    }

    /// Warns of a parameter that the importing version of axgen did not know, or that was added by hand.
    fn warn_of(&mut self, path: &str) {
        let Some(lines) = self.values.get(key(Name::ImportedLines)) else { return };
        let found = format!("`{path}` stands in the imported lines only: the axis does not have it");
        let diagnostic = Diagnostic::warning(codes::PASSED_OVER, lines.value_place(), found);
        self.report.push(diagnostic.instead("the value below the axis, or import the list again"));
    }

    /// Lines for values without a line, in the order of the set. Keys that a controller does not know become comments, with
    /// a warning.
    fn rest(&mut self, written: &BTreeSet<Key>, is_new: bool) -> Vec<String> {
        // The original list had no cycle time.
        let values = self.values.iter().filter(|((name, _), _)| *name != Name::CycleTime || is_new);
        let mut lines = Vec::new();
        for (key, setting) in values {
            let parameter = key.0.parameter();
            let path = path_with(setting.spelling, key.1);
            let own = own_key::is_own(key.0);
            if own {
                let found =
                    format!("`{path}` is a key of an axis set: no controller knows it, and it stands in a comment");
                self.report.push(Diagnostic::warning(codes::KEY_OF_A_SET, setting.path_place(), found));
            }
            let Some(value) = setting.value.as_ref().filter(|_| own || parameter.scope == Scope::List) else {
                continue;
            };
            if !written.contains(&key) {
                let sign = if own { OWN } else { "" };
                lines.push((setting.path_at, format!("{sign}{path} {}", text_of(key, setting, value))));
            }
        }
        lines.sort();
        lines.into_iter().map(|(_, line)| line).collect()
    }

    /// Reads the list as a controller would: reports errors in its lines, and compares each value with the given one.
    fn prove(&mut self, list: &[u8]) {
        let source = Source::new("the exported list", list.to_vec(), Encoding::Plain);
        let read = list::read(&AxisList { source, range: 0..list.len(), name: None, said: None });
        let errors = read.report.diagnostics.into_iter().filter(|said| said.severity == Severity::Error);
        self.report.diagnostics.extend(errors);
        let is_in_it = |name: Name| name.parameter().scope == Scope::List || own_key::is_own(name);
        // The original list had no cycle time.
        let in_it = self.values.iter().filter(|((name, _), _)| is_in_it(*name) && *name != Name::CycleTime);
        for (key, setting) in in_it {
            let found = read.values.get(key).or_else(|| read.own.get(key)).map(|setting| &setting.value);
            assert!(self.report.has_errors() || found == Some(&setting.value), "export: {key:?} is {found:?}");
        }
    }
}

fn text_of((name, _): Key, setting: &Setting, value: &Value) -> String {
    spelling::in_list(name, &setting.source.bytes[setting.value_at..], value)
}
