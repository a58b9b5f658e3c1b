//! `axgen init`: a commented set to start from.

use crate::exit::Exit;
use crate::one_file::{self, Rule};
use crate::output;
use generator::diagnostics::Slashes;
use std::path::Path;

/// The set: complete, checked by a test, and safe: it starts in DRYRUN.
pub const STARTER: &str = include_str!("starter.toml");

/// Runs the command. An existing file is never changed.
pub fn run(path: &Path) -> Result<Exit, Exit> {
    one_file::named(Some(path), true)?;
    one_file::commit([one_file::stage(path, STARTER.as_bytes(), Rule::NEVER)?])?;
    output::line(format!("{}: edit it, then: axgen check {0}", path.slashes()))?;
    Ok(Exit::Done)
}
