//! Errors in a file of samples.

use generator::codes;

/// An error and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// the code of its message
    pub code: &'static str,
    /// the line, counted from 1
    pub line: usize,
    /// the column in characters, counted from 1
    pub column: usize,
    /// what was found
    pub found: String,
    /// what is allowed
    pub allowed: String,
    /// what to do; empty if the allowed values are sufficient
    pub instead: String,
}

impl Mistake {
    /// An error in a column or a cell.
    #[must_use]
    pub fn new([line, column]: [usize; 2], found: impl Into<String>, allowed: impl Into<String>) -> Self {
        let (found, allowed) = (found.into(), allowed.into());
        Self { code: codes::SAMPLES, line, column, found, allowed, instead: String::new() }
    }

    /// The error with its own code.
    #[must_use]
    pub fn coded(self, code: &'static str) -> Self {
        Self { code, ..self }
    }

    /// The error with a remedy.
    #[must_use]
    pub fn instead(self, instead: impl Into<String>) -> Self {
        Self { instead: instead.into(), ..self }
    }
}
