//! The exit codes, which scripts rely on, and the way in which a failure is said.

use std::fmt::Display;
use std::process::ExitCode;

/// How the command ends. A text goes to standard error.
#[derive(Debug)]
pub enum Exit {
    /// 0
    Done,
    /// 1: a check found a difference
    Different,
    /// 2: the input is wrong; nothing was written
    Input(String),
    /// 3: the environment is: no compiler, no permission, no space
    Environment(String),
}

impl Exit {
    /// The input is wrong.
    pub fn input(text: impl Display) -> Self {
        Self::Input(text.to_string())
    }

    /// The environment is wrong.
    pub fn environment(text: impl Display) -> Self {
        Self::Environment(text.to_string())
    }

    /// Says why, if there is anything to say.
    pub fn say(self) -> Self {
        match &self {
            Self::Input(text) | Self::Environment(text) if !text.is_empty() => eprintln!("{}", text.trim_end()),
            _ => {}
        }
        self
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
