//! `axgen import`: an axis list as a TOML set.

use crate::arguments::OneFile;
use crate::exit::Exit;
use crate::input::said;
use crate::messages::Format;
use crate::one_file::{self, Rule};
use generator::config::{self, ListOptions};
use generator::import_export;
use std::path::Path;

/// Runs the command. Without a cycle time, the set has a line to fill in.
pub fn run(list: &Path, options: &ListOptions, to: &OneFile, format: Format) -> Result<Exit, Exit> {
    let out = to.out.as_deref();
    one_file::kept_apart(out, [list])?;
    one_file::named(out, true)?;
    let (set, report) = import_export::import(list, options, &config::load);
    let set = said(set, &report, format)?;
    one_file::write(out, set.as_bytes(), Rule::by_force(to.force))?;
    Ok(Exit::Done)
}
