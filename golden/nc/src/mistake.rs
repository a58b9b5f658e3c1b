//! Errors of an NC program with their places: one message for each place, with what is allowed there and what to write
//! instead.

use super::foreign::Foreign;
use super::passed::{PassedKind, PassedOver};
use std::collections::BTreeMap;
use std::fmt;

/// A place of a program that the reader rejects.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Mistake {
    /// line of the file, from 1
    pub line: usize,
    /// character of the line, from 1
    pub column: usize,
    /// the text there
    pub found: String,
    /// the allowed text
    pub allowed: String,
    /// what to write instead
    pub instead: String,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, column, found, allowed, instead } = self;
        write!(f, "{line}:{column}: error: found {found}; allowed: {allowed}; write {instead}")
    }
}

impl std::error::Error for Mistake {}

/// At most this number is listed for a file.
const MOST: usize = 1000;

const ALLOWED: &str =
    "straight moves (`G00`, `G01`), dwell, homing, feedforward, the words of spindle 1 and words that are passed over";

/// The messages about a program, as they are found.
#[derive(Default)]
pub(crate) struct Mistakes {
    /// the line that is being read
    pub(crate) line: usize,
    pub(crate) passed: PassedOver,
    list: Vec<Mistake>,
    count: usize,
    /// by kind and word: the first place, and the count
    foreign: BTreeMap<(Foreign, String), (Mistake, usize)>,
}

impl Mistakes {
    /// Reports an error in the present line.
    pub(crate) fn push(
        &mut self,
        column: usize,
        found: impl Into<String>,
        allowed: impl Into<String>,
        instead: impl Into<String>,
    ) {
        self.count += 1;
        if self.list.len() < MOST {
            let (found, allowed, instead) = (found.into(), allowed.into(), instead.into());
            self.list.push(Mistake { line: self.line, column, found, allowed, instead });
        }
    }

    /// A word that is not read, reported once for all equal words: a program with an arc has thousands.
    pub(crate) fn foreign(&mut self, column: usize, text: &str, foreign: Foreign) {
        self.count += 1;
        let (what, instead) = foreign.said();
        let is_numbered = text.starts_with(['G', 'g', 'M', 'm']) || foreign == Foreign::Unknown;
        let key = if is_numbered { text.to_ascii_uppercase() } else { String::new() };
        if self.foreign.len() >= MOST && !self.foreign.contains_key(&(foreign, key.clone())) {
            return;
        }
        let line = self.line;
        let first = || {
            let found = format!("{}, {what}", shown(text));
            (Mistake { line, column, found, allowed: ALLOWED.to_owned(), instead: instead.to_owned() }, 0)
        };
        self.foreign.entry((foreign, key)).or_insert_with(first).1 += 1;
    }

    /// A word of the present line that is passed over.
    pub(crate) fn pass(&mut self, kind: PassedKind, column: usize, word: &str) {
        self.passed.push(kind, self.line, column, word);
    }

    /// The number of errors.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// All errors, in the order of the file, each once.
    pub(crate) fn sorted(mut self) -> Vec<Mistake> {
        self.list.extend(self.foreign.into_values().map(|(mut mistake, count)| {
            if count > 1 {
                mistake.found += &format!(" (the first of {count})");
            }
            mistake
        }));
        self.list.sort();
        self.list.dedup();
        self.list.truncate(MOST);
        self.list
    }
}

/// Text of the file for a message: a long one is shortened, characters that control a terminal are shown by their codes.
pub(crate) fn shown(text: &str) -> String {
    const LENGTH: usize = 40;
    let mut shown = String::from("`");
    for letter in text.chars().take(LENGTH) {
        match letter {
            ' '..='~' => shown.push(letter),
            _ => shown.extend(letter.escape_debug()),
        }
    }
    shown + if text.chars().nth(LENGTH).is_some() { "...`" } else { "`" }
}
