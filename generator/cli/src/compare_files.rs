//! `axgen generate --check` and `--diff`: what on disk differs from what would be written. Nothing is written.

use crate::exit::Exit;
use generator::target::File;
use similar::TextDiff;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// How differences are said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Show {
    /// the files' names
    Names,
    /// their lines
    Lines,
}

/// Compares the files with those of a folder; says every difference. Silent where there is none.
#[expect(clippy::print_stdout, reason = "what the command has found")]
pub fn run(files: &[File], folder: &Path, show: Show) -> Result<Exit, Exit> {
    let mut exit = Exit::Done;
    for file in files {
        let path = folder.join(&file.name);
        let found = match fs::read(&path) {
            Ok(bytes) => Some(bytes),
            Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => None,
            Err(error) => return Err(Exit::environment(format!("{}: {error}", path.display()))),
        };
        if found.as_deref() == Some(file.text.as_bytes()) {
            continue;
        }
        exit = Exit::Different;
        match show {
            Show::Names if found.is_none() => println!("{}: is not there", path.display()),
            Show::Names => println!("{}: differs", path.display()),
            Show::Lines => print!("{}", difference(&path, found.as_deref().unwrap_or_default(), &file.text)),
        }
    }
    Ok(exit)
}

/// The lines that differ, as a unified diff: from what is on disk to what would be written.
fn difference(path: &Path, found: &[u8], wanted: &str) -> String {
    let found = String::from_utf8_lossy(found);
    let diff = TextDiff::from_lines(found.as_ref(), wanted);
    let name = path.display().to_string();
    diff.unified_diff().header(&name, &format!("{name} (as it would be written)")).to_string()
}
