//! The restrictions of a recording, and what to record instead. Nothing is detected here.

use generator::diagnostics::{Diagnostic, Severity};
use std::borrow::Cow;

/// One sentence about a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// the code of its message
    pub code: &'static str,
    /// whether it prevents a requested measurement
    pub refuses: bool,
    /// what was found
    pub found: String,
    /// what to do
    pub instead: Cow<'static, str>,
}

impl Verdict {
    /// Something is not measured.
    #[must_use]
    pub fn refusal(code: &'static str, found: impl Into<String>, instead: impl Into<Cow<'static, str>>) -> Self {
        Self { code, refuses: true, found: found.into(), instead: instead.into() }
    }

    /// A verdict on a measurement about which the reader has to know or to state something.
    pub(crate) fn note(code: &'static str, found: impl Into<String>, instead: impl Into<Cow<'static, str>>) -> Self {
        Self { code, refuses: false, found: found.into(), instead: instead.into() }
    }
}

/// A message about a measured response.
impl From<Diagnostic> for Verdict {
    fn from(said: Diagnostic) -> Self {
        let allowed = said.allowed.map_or_else(String::new, |allowed| format!(" (allowed: {allowed})"));
        let found = format!("the measured response: {}{allowed}", said.found);
        let instead = said.instead.unwrap_or_default().into();
        Self { code: said.code, refuses: said.severity == Severity::Error, found, instead }
    }
}
