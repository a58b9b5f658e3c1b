//! The exit codes, on which scripts rely, and the report of a failure.

use crate::messages::{self, Format};
use crate::output;
use commands::refused;
use generator::codes;
use generator::diagnostics::{Diagnostic, Place, Report};
use std::fmt::Display;
use std::process::ExitCode;

/// The end of the command. Messages that have not been reported yet are printed to standard error.
#[derive(Debug)]
pub enum Exit {
    /// 0
    Done,
    /// 1: a check found a difference
    Different,
    /// 2: the input is wrong; nothing was written
    Input(Report),
    /// 3: the environment failed: no compiler, no permission, no space
    Environment(Report),
}

impl Exit {
    /// An error in the input; `of` is the file or the option.
    pub fn input(code: &'static str, of: impl Display, found: impl Display) -> Self {
        Self::Input(refused::input(code, of, found))
    }

    /// An error of the environment; `of` is the file or the program.
    pub fn environment(code: &'static str, of: impl Display, found: impl Display) -> Self {
        Self::Environment(Diagnostic::error(code, Place::whole(of), found.to_string()).into())
    }

    /// A file or standard output cannot be written.
    pub fn unwritable(of: impl Display, error: impl Display) -> Self {
        Self::environment(codes::UNWRITABLE, of, error)
    }

    /// Reports the reason, if it has not been reported.
    pub fn say(self, format: Format) -> Self {
        if let Self::Input(report) | Self::Environment(report) = &self {
            output::say(&messages::text(report, format));
        }
        self
    }
}

impl From<Report> for Exit {
    fn from(report: Report) -> Self {
        Self::Input(report)
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(match exit {
            Exit::Done => 0,
            Exit::Different => 1,
            Exit::Input(_) => 2,
            Exit::Environment(_) => 3,
        })
    }
}
