//! `axgen generate --check` and `--diff`: what on disk differs from what would be written. Nothing is written.

use crate::exit::Exit;
use crate::output;
use generator::config;
use generator::diagnostics::Slashes;
use generator::target::File;
use similar::TextDiff;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

/// How differences are said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Show {
    /// the files' names
    Names,
    /// their lines
    Lines,
}

/// What is said of a file that differs from the one in a folder; none: it does not.
pub fn difference(file: &File, folder: &Path, show: Show) -> Result<Option<String>, Exit> {
    let path = folder.join(&file.name);
    let is_missing = |error: io::Error| matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory);
    let found = match config::load(&path) {
        Ok(bytes) => Some(bytes),
        Err(_) if fs::metadata(&path).is_err_and(is_missing) => None,
        Err(unreadable) => {
            let (code, found) = unreadable.said();
            return Err(Exit::environment(code, path.slashes(), found));
        }
    };
    if found.as_deref() == Some(file.text.as_bytes()) {
        return Ok(None);
    }
    Ok(Some(match show {
        Show::Names if found.is_none() => format!("{}: is not there\n", path.slashes()),
        Show::Names => format!("{}: differs\n", path.slashes()),
        Show::Lines => lines(&path, found.as_deref().unwrap_or_default(), &file.text),
    }))
}

/// Says every difference. Silent where there is none.
pub fn say(differences: Vec<Result<Option<String>, Exit>>) -> Result<Exit, Exit> {
    let mut exit = Exit::Done;
    for difference in differences {
        if let Some(text) = difference? {
            output::print(text)?;
            exit = Exit::Different;
        }
    }
    Ok(exit)
}

/// The lines that differ, as a unified diff: from what is on disk to what would be written.
fn lines(path: &Path, found: &[u8], wanted: &str) -> String {
    let found = String::from_utf8_lossy(found);
    let diff = TextDiff::from_lines(found.as_ref(), wanted);
    let name = path.slashes();
    diff.unified_diff().header(&name, &format!("{name} (as it would be written)")).to_string()
}
