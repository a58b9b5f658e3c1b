//! Messages about the input: code, place, what was found, what is allowed, what to write instead.

use crate::codes;
use std::fmt;
use std::path::{MAIN_SEPARATOR, Path};

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// nothing is written
    Error,
    /// legal, but inert, deprecated or dangerous
    Warning,
}

/// A path in messages and lists of files: with `/` between its parts on every host, including `//server/share`.
pub trait Slashes {
    fn slashes(&self) -> String;
}

impl Slashes for Path {
    fn slashes(&self) -> String {
        with_slashes(&self.to_string_lossy(), MAIN_SEPARATOR)
    }
}

pub fn with_slashes(path: &str, separator: char) -> String {
    path.replace(separator, "/")
}

/// A place: lines and columns count from 1, columns count characters.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// as the user named it
    pub file: String,
    /// 0 for the file as a whole
    pub line: usize,
    /// 0 for the line as a whole
    pub column: usize,
}

impl Place {
    /// The place of a whole file, of an option or of the standard output. A message stays on one line for any name.
    pub fn whole(file: impl fmt::Display) -> Self {
        let name = file.to_string();
        let is_plain = !name.contains(char::is_control);
        let file = if is_plain { name } else { name.chars().flat_map(char::escape_debug).collect() };
        Self { file, line: 0, column: 0 }
    }
}

/// A text in which everything is escaped that could end a line, control a terminal or change the direction of the letters.
pub(crate) fn on_a_line(text: &str) -> String {
    let mut line = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '"' | '\'' | '\\' => line.push(letter),
            other => line.extend(other.escape_debug()),
        }
    }
    line
}

#[must_use = "it is said only if it goes into a report"]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// from the list in [`crate::codes`]
    pub code: &'static str,
    pub severity: Severity,
    pub place: Place,
    pub found: String,
    pub allowed: Option<String>,
    /// what to write instead
    pub instead: Option<String>,
}

impl Diagnostic {
    pub fn error(code: &'static str, place: Place, found: impl Into<String>) -> Self {
        Self { code, severity: Severity::Error, place, found: found.into(), allowed: None, instead: None }
    }

    pub fn warning(code: &'static str, place: Place, found: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(code, place, found) }
    }

    pub fn allowed(self, allowed: impl Into<String>) -> Self {
        Self { allowed: Some(allowed.into()), ..self }
    }

    pub fn instead(self, instead: impl Into<String>) -> Self {
        Self { instead: Some(instead.into()), ..self }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let severity = match self.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        let Place { file, line, column } = &self.place;
        match (line, column) {
            (0, _) => write!(f, "{file}")?,
            (_, 0) => write!(f, "{file}:{line}")?,
            _ => write!(f, "{file}:{line}:{column}")?,
        }
        write!(f, ": {severity}[{}]: {}", self.code, self.found)?;
        for (what, text) in [("allowed", &self.allowed), ("write instead", &self.instead)] {
            text.iter().try_for_each(|text| write!(f, "\n    {what}: {text}"))?;
        }
        Ok(())
    }
}

/// All messages about one input.
#[must_use = "a mistake in an unused report reaches nobody"]
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// in the order of their discovery
    pub diagnostics: Vec<Diagnostic>,
}

/// At most this number of messages is listed, the rest is counted: a file of 64 MiB can cause millions.
const MOST_MESSAGES: usize = 1000;

impl Report {
    /// The report with at most `MOST_MESSAGES` messages, and the number of the others.
    pub fn shortened(mut self) -> Self {
        if self.diagnostics.len() > MOST_MESSAGES {
            let rest = Self { diagnostics: self.diagnostics.split_off(MOST_MESSAGES) };
            let place = Place { line: 0, column: 0, ..self.diagnostics[MOST_MESSAGES - 1].place.clone() };
            let found = format!("{} more messages are not listed", rest.diagnostics.len());
            self.push(match rest.has_errors() {
                true => Diagnostic::error(codes::NOT_LISTED, place, found),
                false => Diagnostic::warning(codes::NOT_LISTED, place, found),
            });
        }
        self
    }

    pub fn push(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    pub(crate) fn extend(&mut self, other: Self) {
        self.diagnostics.extend(other.diagnostics);
    }

    /// Whether a message is an error.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error)
    }

    pub fn warnings(&self) -> usize {
        self.diagnostics.iter().filter(|d| d.severity == Severity::Warning).count()
    }
}

impl From<Diagnostic> for Report {
    fn from(diagnostic: Diagnostic) -> Self {
        Self { diagnostics: vec![diagnostic] }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.diagnostics.iter().try_for_each(|diagnostic| writeln!(f, "{diagnostic}"))
    }
}
