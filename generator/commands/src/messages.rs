//! Messages with the lines that they are about: as text with a mark, and as data.

use generator::config;
use generator::diagnostics::{Diagnostic, Place, Report, Severity};
use serde::Serialize;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Characters of a line that are shown around a mark.
const WIDTH: usize = 100;

/// Longer lines, in bytes, are not shown: they are not hand-written, and each message about one would cost as much as the
/// line.
const LONGEST: usize = 10_000;

/// The byte order mark that some editors write. It is not a character of the first line.
const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// The bytes of a file that a message names, to show a line of it; `None` if it cannot be read again.
pub type Again<'a> = &'a dyn Fn(&str) -> Option<Vec<u8>>;

/// A message.
#[derive(Clone, Debug, Serialize)]
pub struct Message {
    /// `error` or `warning`
    pub severity: &'static str,
    pub code: &'static str,
    /// lines and columns count from 1; 0 for the file, or the line, as a whole
    pub file: String,
    pub line: usize,
    pub column: usize,
    pub found: String,
    pub allowed: Option<String>,
    /// what to write instead
    pub instead: Option<String>,
    /// the line of the file
    pub text: Option<String>,
}

/// All messages as text, each with its line and a mark.
#[must_use]
pub fn text(report: &Report, again: Again<'_>) -> String {
    each(report, again, |diagnostic, line| human(&diagnostic, line.as_deref())).concat()
}

/// All messages as data.
#[must_use]
pub fn data(report: &Report, again: Again<'_>) -> Vec<Message> {
    each(report, again, |diagnostic, line| {
        let Diagnostic { code, severity, place, found, allowed, instead } = diagnostic.into_owned();
        let severity = match severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        let Place { file, line: number, column } = place;
        let text = line.map(|line| visible(&line));
        Message { severity, code, file, line: number, column, found, allowed, instead, text }
    })
}

fn each<T>(
    report: &Report,
    again: Again<'_>,
    mut show: impl FnMut(Cow<'_, Diagnostic>, Option<String>) -> T,
) -> Vec<T> {
    let mut files = BTreeMap::new();
    let seen = report.diagnostics.iter().map(|diagnostic| {
        let (diagnostic, line) = seen(diagnostic, &mut files, again);
        show(diagnostic, line)
    });
    seen.collect()
}

fn human(diagnostic: &Diagnostic, line: Option<&str>) -> String {
    let said = diagnostic.to_string();
    let (head, rest) = said.split_once('\n').unwrap_or((&said, ""));
    let mut text = format!("{head}\n");
    if let Some(line) = line {
        let number = diagnostic.place.line.to_string();
        let gap = " ".repeat(number.len());
        let (shown, mark) = around(line, diagnostic.place.column);
        let _ = writeln!(text, "  {number} | {shown}\n  {gap} | {}^", " ".repeat(mark));
    }
    if !rest.is_empty() {
        let _ = writeln!(text, "{rest}");
    }
    text
}

/// A file that is read again, with the last line that was shown: messages usually come in the order of the lines.
#[derive(Default)]
struct Shown {
    bytes: Vec<u8>,
    line: usize,
    start: usize,
    /// whether these bytes followed a byte order mark
    marked: bool,
}

impl Shown {
    fn of(mut bytes: Vec<u8>) -> Self {
        let marked = bytes.starts_with(BYTE_ORDER_MARK);
        bytes.drain(..if marked { BYTE_ORDER_MARK.len() } else { 0 });
        Self { bytes, marked, ..Self::default() }
    }

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

/// A message and its line, if the file can be read again; each file is read once. A byte order mark counts neither in the
/// line nor in the column.
fn seen<'d>(
    diagnostic: &'d Diagnostic,
    files: &mut BTreeMap<String, Shown>,
    again: Again<'_>,
) -> (Cow<'d, Diagnostic>, Option<String>) {
    let Place { file, line, column } = &diagnostic.place;
    let Some(number) = line.checked_sub(1) else { return (Cow::Borrowed(diagnostic), None) };
    let shown =
        files.entry(file.clone()).or_insert_with(|| Shown::of(again(file).map(config::text).unwrap_or_default()));
    let found = shown.line(number).filter(|line| line.len() <= LONGEST);
    let found = found.map(|line| String::from_utf8_lossy(line).trim_end().to_owned());
    if number > 0 || !shown.marked || *column < 2 {
        return (Cow::Borrowed(diagnostic), found);
    }
    let mut moved = diagnostic.clone();
    moved.place.column -= 1;
    (Cow::Owned(moved), found)
}

/// The part of a line around a column that fits a terminal, and the position of the column in it.
fn around(line: &str, column: usize) -> (String, usize) {
    let at = column.max(1) - 1;
    let start = if at < WIDTH { 0 } else { at - WIDTH / 2 };
    let part = |from: usize, count: usize| visible(&line.chars().skip(from).take(count).collect::<String>());
    let (dots, more) = (if start == 0 { "" } else { "..." }, line.chars().nth(start + WIDTH).is_some());
    let before = format!("{dots}{}", part(start, at - start));
    // A position after the end of the line is marked there.
    let beyond = at.saturating_sub(line.chars().count());
    let mark = before.chars().count() + beyond;
    (format!("{before}{}{}", part(at, start + WIDTH - at), if more { "..." } else { "" }), mark)
}

/// A line in which everything is escaped that could control a terminal, or change the direction of the letters, as in a
/// message.
fn visible(line: &str) -> String {
    let mut text = String::with_capacity(line.len());
    for character in line.chars() {
        match character {
            '\t' => text.push(' '),
            '"' | '\'' | '\\' => text.push(character),
            other => text.extend(other.escape_debug()),
        }
    }
    text
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
    fn what_could_steer_a_terminal_is_written_out_and_the_mark_stays_below_its_place() {
        assert_eq!(around("\u{202e}\u{1b}x", 3), ("\\u{202e}\\u{1b}x".to_owned(), 14));
        assert_eq!(around("\t\"\\'\u{e4} y", 7), (" \"\\'\u{e4} y".to_owned(), 6));
        assert_eq!(around("x", 4), ("x".to_owned(), 3), "after the end of the line");
    }

    #[test]
    fn a_byte_order_mark_is_no_part_of_the_first_line() {
        let mut file = Shown::of(b"\xEF\xBB\xBFone\n\xEF\xBB\xBFtwo".to_vec());
        assert!(file.marked);
        assert_eq!(file.line(0), Some("one".as_bytes()));
        assert_eq!(file.line(1), Some("\u{feff}two".as_bytes()));
    }

    #[test]
    fn lines_are_found_in_any_order() {
        let mut file = Shown::of(b"one\ntwo\n\nfour".to_vec());
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
