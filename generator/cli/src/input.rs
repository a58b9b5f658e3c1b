//! Reading the set that a command names, with its messages on standard error.

use crate::arguments::SetArguments;
use crate::exit::Exit;
use crate::messages::{self, Format};
use generator::axis::Axis;
use generator::config::{self, ListOptions, Set};
use generator::diagnostics::Report;

/// Reads and checks the set; says all messages. With an error the command ends here.
pub fn read(arguments: &SetArguments) -> Result<(Set, usize), Exit> {
    let options = ListOptions { cycle_time: arguments.cycle_time.clone(), name: arguments.name.clone() };
    let (set, report) = config::read(&arguments.set, &options);
    Ok((said(set, &report, arguments.message_format)?, report.warnings()))
}

/// What came of reading, with all messages on standard error.
pub fn said<T>(result: Option<T>, report: &Report, format: Format) -> Result<T, Exit> {
    eprint!("{}", messages::text(report, format));
    result.ok_or_else(|| match format {
        // A machine has its objects.
        Format::Json => Exit::input(""),
        Format::Human => {
            let errors = report.diagnostics.len() - report.warnings();
            Exit::input(format!("{}; nothing was written", counted(errors, "error")))
        }
    })
}

/// The axis of that name, or the only one.
pub fn axis<'s>(set: &'s Set, name: Option<&str>) -> Result<&'s Axis, Exit> {
    let names = || set.axes.iter().map(|axis| axis.name.as_str()).collect::<Vec<_>>().join(", ");
    match (name, set.axes.as_slice()) {
        (None, [axis]) => Ok(axis),
        (None, _) => Err(Exit::input(format!("which axis? give --axis with one of: {}", names()))),
        (Some(name), axes) => axes
            .iter()
            .find(|axis| axis.name == name)
            .ok_or_else(|| Exit::input(format!("no axis `{}`; the set has: {}", name.escape_default(), names()))),
    }
}

/// `1 file`, `2 files`.
pub fn counted(count: impl std::fmt::Display, what: &str) -> String {
    let count = count.to_string();
    let plural = if count == "1" { "" } else { "s" };
    format!("{count} {what}{plural}")
}
