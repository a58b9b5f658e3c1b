//! What is wrong with a file of samples.

use generator::codes;

/// What is wrong, and where.
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
    /// what to do; empty: what is allowed says it
    pub instead: String,
}

impl Mistake {
    /// A column or a cell that is wrong.
    #[must_use]
    pub fn new([line, column]: [usize; 2], found: impl Into<String>, allowed: impl Into<String>) -> Self {
        let (found, allowed) = (found.into(), allowed.into());
        Self { code: codes::SAMPLES, line, column, found, allowed, instead: String::new() }
    }

    /// The mistake with a code of its own.
    #[must_use]
    pub fn coded(self, code: &'static str) -> Self {
        Self { code, ..self }
    }

    /// The mistake with a remedy.
    #[must_use]
    pub fn instead(self, instead: impl Into<String>) -> Self {
        Self { instead: instead.into(), ..self }
    }
}
