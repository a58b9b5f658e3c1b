//! Reads the set that a command names, with its messages on standard error.

use crate::arguments::{ListArguments, SetArguments};
use crate::exit::Exit;
use crate::messages::{self, Format};
use crate::output;
use commands::words::counted;
use generator::config::{self, ListOptions, OptionKey};
use generator::diagnostics::Report;
use generator::pipeline::{self, Set};

impl ListArguments {
    /// Its options for an axis list, with options that override keys.
    pub fn options(&self, keys: Vec<OptionKey>) -> ListOptions {
        ListOptions { cycle_time: self.cycle_time.clone(), name: self.name.clone(), keys }
    }
}

/// Reads and checks the set; reports all messages. With an error the command ends here.
pub fn read(arguments: &SetArguments, format: Format) -> Result<(Set, usize), Exit> {
    let (set, report) = pipeline::read(&arguments.set, &arguments.list.options(Vec::new()));
    Ok((said(set, &report, format)?, report.warnings()))
}

/// Reads the set for a command that shows its effect, with options that override keys: an unstable loop is only a warning.
pub fn read_to_look_at(arguments: &SetArguments, keys: Vec<OptionKey>, format: Format) -> Result<(Set, usize), Exit> {
    let (set, report) = pipeline::read_to_look_at(&arguments.set, &arguments.list.options(keys), &config::load);
    Ok((said(set, &report, format)?, report.warnings()))
}

/// Reads the set for a command that proposes stages: the drive is read even if no stage is active yet.
pub fn read_to_tune(arguments: &SetArguments, keys: Vec<OptionKey>, format: Format) -> Result<Set, Exit> {
    let (set, report) = pipeline::read_to_tune(&arguments.set, &arguments.list.options(keys), &config::load);
    said(set, &report, format)
}

/// The result of reading, after printing all messages to standard error.
pub fn said<T>(result: Option<T>, report: &Report, format: Format) -> Result<T, Exit> {
    output::say(&messages::text(report, format));
    result.ok_or_else(|| {
        if format == Format::Human {
            let errors = report.diagnostics.len() - report.warnings();
            output::say(&format!("{}; nothing was written\n", counted(errors, "error")));
        }
        Exit::Input(Report::default())
    })
}
