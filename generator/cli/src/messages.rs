//! Messages on standard error: for people with the line and a mark, for machines as JSON, one object a line.

use clap::ValueEnum;
use generator::diagnostics::{Diagnostic, Report, Severity};
use serde_json::json;
use std::collections::BTreeMap;
use std::fmt::Write;

/// What messages look like.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// with the line of the file and a mark
    Human,
    /// a JSON object on a line of its own
    Json,
}

/// Characters of a line that are shown around a mark.
const WIDTH: usize = 100;

/// Longer lines, in bytes, are not shown: nobody wrote them, and each message about one would cost as much as the line.
const LONGEST: usize = 10_000;

/// The text of all messages.
pub fn text(report: &Report, format: Format) -> String {
    let mut files = BTreeMap::new();
    report.diagnostics.iter().fold(String::new(), |mut text, diagnostic| {
        let line = line_of(diagnostic, &mut files);
        match format {
            Format::Human => human(diagnostic, line.as_deref(), &mut text),
            Format::Json => json(diagnostic, line.as_deref(), &mut text),
        }
        text
    })
}

fn human(diagnostic: &Diagnostic, line: Option<&str>, text: &mut String) {
    let said = diagnostic.to_string();
    let (head, rest) = said.split_once('\n').unwrap_or((&said, ""));
    let _ = writeln!(text, "{head}");
    if let Some(line) = line {
        let number = diagnostic.place.line.to_string();
        let gap = " ".repeat(number.len());
        let (shown, mark) = around(line, diagnostic.place.column);
        let _ = writeln!(text, "  {number} | {shown}\n  {gap} | {}^", " ".repeat(mark));
    }
    if !rest.is_empty() {
        let _ = writeln!(text, "{rest}");
    }
}

fn json(diagnostic: &Diagnostic, line: Option<&str>, text: &mut String) {
    let severity = match diagnostic.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    let place = &diagnostic.place;
    let object = json!({
        "severity": severity,
        "code": diagnostic.code,
        "file": place.file,
        "line": place.line,
        "column": place.column,
        "found": diagnostic.found,
        "allowed": diagnostic.allowed,
        "instead": diagnostic.instead,
        "text": line,
    });
    let _ = writeln!(text, "{object}");
}

/// A file that is read again, with the line that was shown last: messages come in the order of the lines, mostly.
#[derive(Default)]
struct Shown {
    bytes: Vec<u8>,
    line: usize,
    start: usize,
}

impl Shown {
    /// The bytes of a line, counted from 0.
    fn line(&mut self, number: usize) -> Option<&[u8]> {
        if number < self.line {
            (self.line, self.start) = (0, 0);
        }
        while self.line < number {
            self.start += self.bytes[self.start..].iter().position(|byte| *byte == b'\n')? + 1;
            self.line += 1;
        }
        self.bytes[self.start..].split(|byte| *byte == b'\n').next()
    }
}

/// The line that a message is about, as far as it can be read again; each file is read once.
fn line_of(diagnostic: &Diagnostic, files: &mut BTreeMap<String, Shown>) -> Option<String> {
    let place = &diagnostic.place;
    let number = place.line.checked_sub(1)?;
    let file = files
        .entry(place.file.clone())
        .or_insert_with(|| Shown { bytes: std::fs::read(&place.file).unwrap_or_default(), ..Shown::default() });
    let line = file.line(number).filter(|line| line.len() <= LONGEST)?;
    Some(String::from_utf8_lossy(line).chars().map(|c| if c.is_control() { ' ' } else { c }).collect())
}

/// The part of a line around a column, and where the column is in it.
fn around(line: &str, column: usize) -> (String, usize) {
    let line = line.trim_end();
    let at = column.max(1) - 1;
    let start = if at < WIDTH { 0 } else { at - WIDTH / 2 };
    let mut shown: String = line.chars().skip(start).take(WIDTH).collect();
    if line.chars().nth(start + WIDTH).is_some() {
        shown.push_str("...");
    }
    if start == 0 { (shown, at) } else { (format!("...{shown}"), at - start + 3) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_line_is_shown_whole() {
        assert_eq!(around("a b", 3), ("a b".to_owned(), 2));
        assert_eq!(around("a", 0), ("a".to_owned(), 0));
    }

    #[test]
    fn lines_are_found_in_any_order() {
        let mut file = Shown { bytes: b"one\ntwo\n\nfour".to_vec(), ..Shown::default() };
        for (number, line) in [(1, "two"), (3, "four"), (0, "one"), (2, ""), (3, "four")] {
            assert_eq!(file.line(number), Some(line.as_bytes()));
        }
        assert_eq!(file.line(4), None);
        assert_eq!(file.line(0), Some("one".as_bytes()));
    }

    #[test]
    fn of_a_long_line_the_part_around_the_mark_is_shown() {
        let line = "x".repeat(400) + "y" + &"x".repeat(400);
        let (shown, mark) = around(&line, 401);
        assert_eq!(shown.len(), WIDTH + 6);
        assert_eq!(shown.chars().nth(mark), Some('y'));
    }
}
