//! What is wrong with an NC program, and where: one message for each place, with what is allowed there and what to write instead.

use std::fmt;

/// A place of a program that the reader does not take.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Mistake {
    /// line of the file, from 1
    pub line: usize,
    /// character of the line, from 1
    pub column: usize,
    /// what stands there
    pub found: String,
    /// what may stand there
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

/// So many are said of a file, at most.
const MOST: usize = 1000;

/// The mistakes of a program as they are found.
#[derive(Default)]
pub(crate) struct Mistakes {
    /// the line that is being read
    pub(crate) line: usize,
    list: Vec<Mistake>,
}

impl Mistakes {
    /// One in the present line.
    pub(crate) fn push(
        &mut self,
        column: usize,
        found: impl Into<String>,
        allowed: impl Into<String>,
        instead: impl Into<String>,
    ) {
        if self.list.len() < MOST {
            let (found, allowed, instead) = (found.into(), allowed.into(), instead.into());
            self.list.push(Mistake { line: self.line, column, found, allowed, instead });
        }
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.list.len()
    }

    /// All, in the order of the file, each once.
    pub(crate) fn sorted(mut self) -> Vec<Mistake> {
        self.list.sort();
        self.list.dedup();
        self.list
    }
}

/// Text of the file as a message shows it: a long one by its beginning, what a terminal would obey by its code.
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
