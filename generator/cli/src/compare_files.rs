//! `axgen generate --check` and `--diff`: the differences between the disk and the generated files. Nothing is written.

use crate::exit::Exit;
use crate::leftovers::{Leftovers, Scope};
use crate::output;
use crate::recorded::Recorded;
use commands::plan::Plan;
use generator::config;
use generator::diagnostics::Slashes;
use generator::digest::is_text;
use generator::manifest;
use generator::target::File;
use similar::TextDiff;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

/// The form in which differences are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Show {
    /// the files' names
    Names,
    /// their lines
    Lines,
}

/// Compares a folder with the generated files, and shows every difference. Prints nothing if there is none.
pub fn run(plan: &Plan<'_>, recorded: &Recorded, scope: &Scope<'_>, show: Show) -> Result<Exit, Exit> {
    let files = plan.files(&recorded.set, |file| difference(file, &recorded.out, show));
    let made = files.iter().map(|(name, entry, _)| (name.as_str(), entry.as_ref())).collect();
    let leftovers = Leftovers::new(recorded, scope, &made);
    let manifest = File { name: manifest::NAME.to_owned(), text: manifest::text(&leftovers.after) };
    let manifest = difference(&manifest, &recorded.out, show);
    let left_over = leftovers.differences(&recorded.out).into_iter().map(|line| Ok(Some(line)));
    say(files.into_iter().map(|(.., difference)| difference).chain([manifest]).chain(left_over))
}

/// The text about a file that differs from the one in a folder; `None` if it does not differ.
fn difference(file: &File, folder: &Path, show: Show) -> Result<Option<String>, Exit> {
    let path = folder.join(&file.name);
    let is_missing = |error: io::Error| matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory);
    let found = match config::load(&path) {
        Ok(bytes) => Some(bytes),
        Err(_) if fs::metadata(&path).is_err_and(is_missing) => None,
        Err(unreadable) => return Err(Exit::Environment(unreadable.diagnostic(path.slashes()).into())),
    };
    if found.as_deref().is_some_and(|found| is_text(found, &file.text)) {
        return Ok(None);
    }
    Ok(Some(match show {
        Show::Names if found.is_none() => format!("{}: is not there\n", path.slashes()),
        Show::Names => format!("{}: differs\n", path.slashes()),
        Show::Lines => lines(&path, found.as_deref().unwrap_or_default(), &file.text),
    }))
}

fn say(differences: impl Iterator<Item = Result<Option<String>, Exit>>) -> Result<Exit, Exit> {
    let mut exit = Exit::Done;
    for difference in differences {
        if let Some(text) = difference? {
            output::print(text)?;
            exit = Exit::Different;
        }
    }
    Ok(exit)
}

/// The differing lines as a unified diff, from the file on disk to the generated one.
fn lines(path: &Path, found: &[u8], wanted: &str) -> String {
    let found = String::from_utf8_lossy(found);
    let diff = TextDiff::from_lines(found.as_ref(), wanted);
    let name = path.slashes();
    diff.unified_diff().header(&name, &format!("{name} (as it would be written)")).to_string()
}
