//! `axgen import`: an axis list as a TOML set.

use crate::exit::Exit;
use crate::input::said;
use crate::messages::Format;
use crate::one_file::{self, Rule};
use generator::config::{self, ListOptions};
use generator::import_export;
use std::path::Path;

/// What the command takes, in addition to the list.
pub struct ImportArguments<'r> {
    /// the cycle time of the set; none: the set has a line to fill in
    pub cycle_time: Option<String>,
    /// the name of the axis; `None` for the file's name
    pub name: Option<String>,
    /// the file to write; `None` or `-` for standard output
    pub out: Option<&'r Path>,
    /// whether an existing file may be replaced
    pub force: bool,
    /// the format of messages
    pub format: Format,
}

/// Runs the command.
pub fn run(list: &Path, request: ImportArguments<'_>) -> Result<Exit, Exit> {
    let ImportArguments { cycle_time, name, out, force, format } = request;
    one_file::kept_apart(out, [list])?;
    let (set, report) =
        import_export::import(list, &ListOptions { cycle_time, name, ..ListOptions::default() }, &config::load);
    let set = said(set, &report, format)?;
    one_file::write(out, set.as_bytes(), Rule::by_force(force))?;
    Ok(Exit::Done)
}
