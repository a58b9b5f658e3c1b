//! `axgen golden`: vectors to keep in a repository, and their check.

use crate::exit::Exit;
use crate::output;
use crate::results::{Files, Outcome};
use generator::codes;
use generator::diagnostics::Slashes;
use golden::case::{self, Case};
use std::path::{Path, PathBuf};

/// Writes the vectors of every case, after those of all cases have been computed. Inputs of a scenario are written only if
/// there are none, or with `again`.
pub fn record(folders: &[PathBuf], again: bool) -> Result<Exit, Exit> {
    let cases = read_all(folders)?;
    let recorded = |case: &Case| {
        let made = case::scenario_inputs(case, again)?;
        case::recorded(case, made)
    };
    let files = cases.iter().map(|case| recorded(case).map_err(|text| unusable(&case.folder, text)));
    for (case, files) in cases.iter().zip(files.collect::<Result<Vec<_>, Exit>>()?) {
        let failed = |text| Exit::environment(codes::CASE, case.folder.slashes(), text);
        case::keep(case, &files).map_err(failed)?;
        output::line(format!("{}: recorded", case.folder.slashes()))?;
    }
    Ok(Exit::Done)
}

/// Compares the vectors of every case.
pub fn verify(folders: &[PathBuf], files: &Files) -> Result<Exit, Exit> {
    files.kept_apart(None)?;
    let (mut exit, mut outcomes) = (Exit::Done, Vec::new());
    for case in read_all(folders)? {
        let differing = case::verify(&case).map_err(|text| unusable(&case.folder, text))?;
        let failure = (!differing.is_empty()).then(|| format!("differs in {}", differing.join(", ")));
        output::line(format!("{}: {}", case.folder.slashes(), failure.as_deref().unwrap_or("as recorded")))?;
        if failure.is_some() {
            exit = Exit::Different;
        }
        outcomes.push(Outcome { group: case.folder.slashes(), name: case.block.program.block.to_owned(), failure });
    }
    files.write("axgen golden verify", &outcomes)?;
    Ok(exit)
}

/// Reads all cases before any of them is processed.
fn read_all(folders: &[PathBuf]) -> Result<Vec<Case>, Exit> {
    folders.iter().map(|folder| case::read(folder).map_err(|text| unusable(folder, text))).collect()
}

fn unusable(folder: &Path, why: String) -> Exit {
    Exit::input(codes::CASE, folder.slashes(), why.trim_end())
}
