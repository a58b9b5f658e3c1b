//! `axgen golden`: vectors to keep in a repository, and their check.

use crate::exit::Exit;
use golden::case::{self, Case};
use std::path::{Path, PathBuf};

/// Writes the vectors of every case.
#[expect(clippy::print_stdout, reason = "what the command has done")]
pub fn record(folders: &[PathBuf]) -> Result<Exit, Exit> {
    for case in read_all(folders)? {
        case::record(&case).map_err(Exit::environment)?;
        println!("{}: recorded", case.folder.display());
    }
    Ok(Exit::Done)
}

/// Compares the vectors of every case.
#[expect(clippy::print_stdout, reason = "what the command has found")]
pub fn verify(folders: &[PathBuf]) -> Result<Exit, Exit> {
    let mut exit = Exit::Done;
    for case in read_all(folders)? {
        let differing = case::verify(&case).map_err(Exit::input)?;
        if differing.is_empty() {
            println!("{}: as recorded", case.folder.display());
        } else {
            println!("{}: differs in {}", case.folder.display(), differing.join(", "));
            exit = Exit::Different;
        }
    }
    Ok(exit)
}

/// Reads all cases before anything is done with one.
fn read_all(folders: &[PathBuf]) -> Result<Vec<Case>, Exit> {
    folders.iter().map(|folder: &PathBuf| case::read(Path::new(folder)).map_err(Exit::input)).collect()
}
