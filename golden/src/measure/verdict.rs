//! The restrictions of a recording, and what to record instead. Nothing is detected here.

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
    pub instead: &'static str,
}

impl Verdict {
    /// A verdict that prevents a measurement.
    pub(crate) fn refusal(code: &'static str, found: impl Into<String>, instead: &'static str) -> Self {
        Self { code, refuses: true, found: found.into(), instead }
    }

    /// A verdict on a measurement about which the reader has to know or to state something.
    pub(crate) fn note(code: &'static str, found: impl Into<String>, instead: &'static str) -> Self {
        Self { code, refuses: false, found: found.into(), instead }
    }
}
