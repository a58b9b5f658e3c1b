//! `axgen export`: an axis of a set as an axis list.

use crate::exit::Exit;
use crate::input::said;
use crate::messages::Format;
use crate::one_file::{self, Rule};
use generator::{config, import_export};
use std::path::Path;

/// Runs the command: the axis may be left out where the set has one; without a file, or to `-`, it writes to standard
/// output; a file that is there is replaced only by force.
pub fn run(set: &Path, axis: Option<&str>, out: Option<&Path>, force: bool, format: Format) -> Result<Exit, Exit> {
    let (list, report) = import_export::export(set, axis, &config::load);
    let list = said(list, &report, format)?;
    one_file::write(out, &list, Rule::by_force(force))?;
    Ok(Exit::Done)
}
