//! Renames staged files to their targets and removes other files, all or none. At any moment a target has its complete old
//! or new content.

use super::temporary::{kept, remove, staged};
use super::{Change, Refusal, Staged};
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Renames every staged file, and removes every file that goes; restores the old files after a failure.
pub(super) fn all(files: &[Staged]) -> Result<(), Refusal> {
    let mut replaced: Vec<Replaced<'_>> = Vec::with_capacity(files.len());
    for Staged { path, change } in files.iter().filter(|file| file.change != Change::None) {
        let done = keep(path).and_then(|old| {
            let done = match change {
                Change::Remove => removed(path),
                Change::None | Change::Write(_) | Change::Record => fs::rename(staged(path), path),
            };
            replaced.push(Replaced { path, old, new: done.is_ok() && *change != Change::Remove });
            done
        });
        if let Err(error) = done {
            let torn: Vec<PathBuf> = replaced.iter().rev().filter_map(put_back).collect();
            let path = path.clone();
            return Err(if torn.is_empty() { Refusal::Failed(path, error) } else { Refusal::Torn(path, error, torn) });
        }
    }
    replaced.iter().filter(|file| file.old).for_each(|file| remove(&kept(file.path)));
    Ok(())
}

/// A target and the progress of its replacement.
struct Replaced<'p> {
    path: &'p Path,
    old: bool,
    new: bool,
}

fn keep(path: &Path) -> io::Result<bool> {
    match fs::symlink_metadata(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(false),
        Err(error) => return Err(error),
        Ok(found) if !found.is_file() => return Err(io::Error::other("is no longer a regular file")),
        Ok(_) => {}
    }
    // Without hard links in the file system, the target is missing for a moment.
    fs::hard_link(path, kept(path)).or_else(|_| fs::rename(path, kept(path)))?;
    Ok(true)
}

/// Removes a file; not an error if it no longer exists.
fn removed(path: &Path) -> io::Result<()> {
    match fs::remove_file(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(()),
        done => done,
    }
}

/// Undoes the replacement of one file; returns its path if that fails.
fn put_back(file: &Replaced<'_>) -> Option<PathBuf> {
    if !file.old {
        return (file.new && fs::remove_file(file.path).is_err()).then(|| file.path.to_owned());
    }
    if fs::rename(kept(file.path), file.path).is_err() {
        return Some(file.path.to_owned());
    }
    remove(&kept(file.path)); // still there if it and the target are one file
    None
}
