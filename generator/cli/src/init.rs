//! `axgen init`: a commented set to start from.

use crate::exit::Exit;
use crate::output;
use generator::codes;
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

/// The set: complete, checked by a test, and safe: it starts in DRYRUN.
pub const STARTER: &str = include_str!("starter.toml");

/// Runs the command. A file that is there already is never touched.
pub fn run(path: &Path) -> Result<Exit, Exit> {
    let failed = |error: std::io::Error| match error.kind() {
        ErrorKind::AlreadyExists => Exit::input(codes::NOT_OURS, path.display(), "is there already; give another name"),
        _ => Exit::unwritable(path.display(), error),
    };
    let mut file = OpenOptions::new().write(true).create_new(true).open(path).map_err(failed)?;
    file.write_all(STARTER.as_bytes()).map_err(failed)?;
    output::line(format!("{}: edit it, then: axgen check {0}", path.display()))?;
    Ok(Exit::Done)
}
