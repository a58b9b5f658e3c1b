//! Puts files into a folder: staged next to their targets, then renamed; all of them or none.
//!
//! ```text
//! folder   created if necessary, locked, cleared of files of a killed run
//! stage    file -> a file next to its target, unless the target belongs to someone else
//! removal  a file that is no longer generated -> removed with the same commit
//! one      a single file by its path, by the caller's rule
//! replace  renames all files, and restores the old ones if one fails
//! ```
//! The guarantees and the reasons: `docs/decisions/files.md`.

mod folder;
mod one;
mod replace;
mod temporary;

pub use folder::{Folder, open};
pub use one::{One, Replace, is_replaced, stage_one};

use crate::codes;
use crate::config::{self, Unreadable};
use crate::diagnostics::{Diagnostic, Place, Report, Slashes};
use crate::digest::{has_right_checksum, is_text};
use crate::target::File;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::{fs, iter};
use temporary::{remove, staged};

/// What was done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// new or changed files
    pub changed: usize,
    /// unchanged files
    pub unchanged: usize,
}

/// The reason why nothing was written.
#[derive(Debug)]
pub enum Refusal {
    /// these files differ from what axgen generated
    Edited(Vec<(PathBuf, Owner)>),
    /// the folder does not accept them
    Failed(PathBuf, io::Error),
    /// the folder does not accept them, and these files, which already had their new content, could not be restored
    Torn(PathBuf, io::Error, Vec<PathBuf>),
}

/// The owner of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    /// axgen: as generated, or empty, so that nothing is lost with it
    Generated,
    /// generated, then edited by hand
    Edited,
    /// another tool or a person; or its checksum was removed
    Other,
}

impl Refusal {
    /// A message for each file.
    pub fn report(&self) -> Report {
        let unwritable =
            |path: &Path, found: String| Diagnostic::error(codes::UNWRITABLE, Place::whole(path.slashes()), found);
        let diagnostics = match self {
            Self::Edited(files) => files.iter().map(|(path, owner)| kept(path, *owner)).collect(),
            Self::Failed(path, error) => vec![unwritable(path, format!("{error}; nothing was written"))],
            Self::Torn(path, error, torn) => {
                let found = format!("{error}; but for the files named below all are as they were before");
                let not_put_back = |path: &PathBuf| {
                    let kept = temporary::kept(path);
                    unwritable(path, format!("could not be put back; as it was before it is {}", kept.slashes()))
                };
                iter::once(unwritable(path, found)).chain(torn.iter().map(not_put_back)).collect()
            }
        };
        Report { diagnostics }
    }
}

fn kept(path: &Path, owner: Owner) -> Diagnostic {
    let (code, found) = match owner {
        Owner::Other => (codes::NOT_OURS, "was not generated, or its line `checksum` was taken out"),
        Owner::Edited | Owner::Generated => (codes::EDITED, "was changed by hand after it had been generated"),
    };
    Diagnostic::error(code, Place::whole(path.slashes()), format!("{found}; nothing was written"))
        .instead("the change in what the file is made from; or overwrite it with --force")
}

/// A file to be written or removed. The staged file is removed together with this value in any case.
#[derive(Debug)]
pub struct Staged {
    /// its target
    pub path: PathBuf,
    change: Change,
}

/// The change of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Change {
    /// unchanged
    None,
    /// it replaces a file with this owner; `Generated` if there is none
    Write(Owner),
    /// it is the record of the folder itself, which is always replaced, and is not counted as a file
    Record,
    Remove,
}

impl Drop for Staged {
    fn drop(&mut self) {
        match self.change {
            Change::Write(_) | Change::Record => remove(&staged(&self.path)), // already gone if it was renamed
            Change::None | Change::Remove => {}
        }
    }
}

/// Writes a file next to its target in the folder. A file that already has this text is left unchanged, apart from changes
/// that `saved` undoes.
///
/// # Errors
/// The folder does not accept it.
pub fn stage(folder: &Folder, file: &File) -> Result<Staged, Refusal> {
    let path = folder.path_of(&file.name)?;
    let replaces = replaced(&path, &file.text).map_err(|error| Refusal::Failed(path.clone(), error))?;
    stage_at(path, &file.text, replaces.map_or(Change::None, Change::Write))
}

/// Writes the folder's own record next to its target, which it replaces.
///
/// # Errors
/// The folder does not accept it.
pub fn record(folder: &Folder, file: &File) -> Result<Staged, Refusal> {
    let path = folder.path_of(&file.name)?;
    replaced(&path, &file.text).map_err(|error| Refusal::Failed(path.clone(), error))?;
    stage_at(path, &file.text, Change::Record)
}

/// A file to be removed.
///
/// # Errors
/// The folder of the file cannot be made.
pub fn removal(folder: &Folder, name: &str) -> Result<Staged, Refusal> {
    Ok(Staged { path: folder.path_of(name)?, change: Change::Remove })
}

fn stage_at(path: PathBuf, text: &str, change: Change) -> Result<Staged, Refusal> {
    if change == Change::None {
        return Ok(Staged { path, change });
    }
    let failed = |error| Refusal::Failed(path.clone(), error);
    // An existing file was not created by this run: it is neither followed nor written, and stays.
    let mut new = fs::OpenOptions::new().write(true).create_new(true).open(staged(&path)).map_err(failed)?;
    let on_its_way = Staged { path: path.clone(), change };
    new.write_all(text.as_bytes()).map_err(failed)?;
    Ok(on_its_way)
}

/// Renames all staged files to their targets, or none: not if one could not be staged, nor, unless `force` is set, if one
/// would replace a file that differs from what was generated.
///
/// # Errors
/// The reason why nothing was written; the folder's files are unchanged.
pub fn commit(folder: Folder, results: Vec<Result<Staged, Refusal>>, force: bool) -> Result<Written, Refusal> {
    let written = commit_in(&folder, results, force);
    drop(folder);
    written
}

/// Renames all staged files as [`commit`] does, and keeps the folder locked.
///
/// # Errors
/// As [`commit`].
pub fn commit_in(folder: &Folder, results: Vec<Result<Staged, Refusal>>, force: bool) -> Result<Written, Refusal> {
    let files = results.into_iter().collect::<Result<Vec<Staged>, Refusal>>()?;
    let foreign = |file: &Staged| match file.change {
        Change::Write(owner) => (owner != Owner::Generated).then(|| (file.path.clone(), owner)),
        Change::None | Change::Record | Change::Remove => None,
    };
    let edited: Vec<_> = files.iter().filter_map(foreign).collect();
    if !edited.is_empty() && !force {
        return Err(Refusal::Edited(edited));
    }
    replace::all(&files)?;
    let removed = files.iter().filter(|file| file.change == Change::Remove);
    removed.for_each(|file| folder.clear_above(&file.path));
    let count = |is_counted: fn(Change) -> bool| files.iter().filter(|file| is_counted(file.change)).count();
    Ok(Written {
        changed: count(|change| matches!(change, Change::Write(_))),
        unchanged: count(|change| change == Change::None),
    })
}

/// The owner of a file with this content.
pub fn owner(content: &[u8]) -> Owner {
    // axgen writes UTF-8 only: with replacement characters the checksum is wrong.
    match has_right_checksum(&String::from_utf8_lossy(content)) {
        Some(true) => Owner::Generated,
        Some(false) => Owner::Edited,
        // A crash of the host can leave an empty file.
        None if content.is_empty() => Owner::Generated,
        None => Owner::Other,
    }
}

/// The owner of the file that a text is to replace. Nothing is written through a link, and only files are read.
fn replaced(path: &Path, text: &str) -> io::Result<Option<Owner>> {
    let found = match fs::symlink_metadata(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Some(Owner::Generated)),
        found => found?.file_type(),
    };
    // `load` refuses everything except files, also through a link.
    if found.is_symlink() && config::load(path).is_ok_and(|old| is_text(&old, text)) {
        return Ok(None);
    }
    is_writable(found)?;
    match config::load(path) {
        Ok(old) => Ok((!is_text(&old, text)).then(|| owner(&old))),
        Err(Unreadable::TooLarge) => Ok(Some(Owner::Other)),
        Err(Unreadable::System(reason)) => Err(io::Error::other(format!("cannot be read: {reason}"))),
    }
}

/// Checks that a file of this type may be written at all.
fn is_writable(found: fs::FileType) -> io::Result<()> {
    match found {
        _ if found.is_symlink() => Err(io::Error::other("is a symbolic link, through which nothing is written")),
        _ if found.is_dir() => Err(ErrorKind::IsADirectory.into()),
        _ if !found.is_file() => Err(io::Error::other("is not a regular file")),
        _ => Ok(()),
    }
}
