//! Refusals of a request: its mistakes as reports. Nothing is decided here.

use generator::diagnostics::{Diagnostic, Place, Report};
use std::fmt::Display;

/// An error in the input; `of` is the file or the option.
pub fn input(code: &'static str, of: impl Display, found: impl Display) -> Report {
    Diagnostic::error(code, Place::whole(of), found.to_string()).into()
}

/// An unknown name in a request, with the known names.
pub fn no_such(option: &str, what: &str, name: &str, known: &[&str]) -> Report {
    let found = format!("no {what} `{}`", name.escape_default());
    Diagnostic::error(generator::codes::NO_SUCH, Place::whole(option), found).allowed(known.join(", ")).into()
}
