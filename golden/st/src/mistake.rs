//! Errors in a text with their places: one message for each place, with what to write instead.

use super::source::Source;
use std::fmt;

/// A place of a text that is outside the portable subset.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Mistake {
    /// line of the file, from 1
    pub line: usize,
    /// character of the line, from 1
    pub column: usize,
    /// the text there
    pub found: String,
    /// what to write instead
    pub instead: String,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: found {}; write {}", self.line, self.column, self.found, self.instead)
    }
}

impl std::error::Error for Mistake {}

/// The start of each line of a file.
pub(crate) struct Lines<'t> {
    file: &'t str,
    starts: Vec<usize>,
}

impl<'t> Lines<'t> {
    /// Finds the starts of all lines.
    pub(crate) fn new(file: &'t str) -> Self {
        let after = file.bytes().enumerate().filter(|&(_, byte)| byte == b'\n').map(|(at, _)| at + 1);
        Self { file, starts: std::iter::once(0).chain(after).collect() }
    }

    /// Line and column of a byte, both from 1.
    pub(crate) fn place(&self, at: usize) -> (usize, usize) {
        let line = self.starts.partition_point(|&start| start <= at).max(1);
        let start = self.starts[line - 1];
        let before = self.file.get(start..at.min(self.file.len())).unwrap_or_default();
        (line, before.trim_start_matches('\u{feff}').chars().count() + 1)
    }

    /// An error at a byte of the file.
    pub(crate) fn mistake(&self, at: usize, found: impl Into<String>, instead: impl Into<String>) -> Mistake {
        let (line, column) = self.place(at);
        Mistake { line, column, found: found.into(), instead: instead.into() }
    }
}

/// At most this number is reported for a file.
const MOST: usize = 1000;

/// The errors of a text as they are found.
pub(crate) struct Mistakes<'t> {
    source: &'t Source,
    lines: Lines<'t>,
    list: Vec<Mistake>,
}

impl<'t> Mistakes<'t> {
    /// Empty.
    pub(crate) fn new(source: &'t Source, file: &'t str) -> Self {
        Self { source, lines: Lines::new(file), list: Vec::new() }
    }

    /// Reports an error at a byte of the source.
    pub(crate) fn push(&mut self, at: usize, found: impl Into<String>, instead: impl Into<String>) {
        if self.list.len() < MOST {
            self.list.push(self.lines.mistake(self.source.origin(at), found, instead));
        }
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// All errors, in the order of the file, each once.
    pub(crate) fn sorted(mut self) -> Vec<Mistake> {
        self.list.sort();
        self.list.dedup();
        self.list
    }
}
