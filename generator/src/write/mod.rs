//! Puts files into a folder: staged next to their targets, then renamed; all of them or none.
//!
//! ```text
//! folder   made if need be, locked, cleared of what a killed run left
//! stage    file -> a file next to its target, unless the target is somebody else's
//! removal  a file that is generated no more -> gone with the same commit
//! one      a single file by its path, by the caller's rule
//! replace  renames them all, and puts back what was there if one fails
//! ```
//! What is promised, and why it is done this way: `docs/decisions/files.md`.

mod beside;
mod folder;
mod one;
mod replace;

pub use folder::{Folder, open};
pub use one::{One, Replace, is_replaced, stage_one};

use crate::codes;
use crate::config::{self, Unreadable};
use crate::diagnostics::{Diagnostic, Place, Report, Slashes};
use crate::digest::{has_right_checksum, is_text};
use crate::target::File;
use beside::{remove, staged};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::{fs, iter};

/// What was done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// files that are new or have changed
    pub changed: usize,
    /// files that were there already
    pub unchanged: usize,
}

/// Why nothing was written.
#[derive(Debug)]
pub enum Refusal {
    /// these files are not as axgen made them
    Edited(Vec<(PathBuf, Owner)>),
    /// the folder does not take them
    Failed(PathBuf, io::Error),
    /// the folder does not take them, and these files, which had their new content already, could not be put back
    Torn(PathBuf, io::Error, Vec<PathBuf>),
}

/// Whose a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    /// ours, as it was generated, or empty: nothing is lost with it
    Generated,
    /// it was generated, and changed by hand
    Edited,
    /// another tool's or a person's; or its checksum was taken out
    Other,
}

impl Refusal {
    /// What is said about it: a message for each file.
    pub fn report(&self) -> Report {
        let unwritable =
            |path: &Path, found: String| Diagnostic::error(codes::UNWRITABLE, Place::whole(path.slashes()), found);
        let diagnostics = match self {
            Self::Edited(files) => files.iter().map(|(path, owner)| kept(path, *owner)).collect(),
            Self::Failed(path, error) => vec![unwritable(path, format!("{error}; nothing was written"))],
            Self::Torn(path, error, torn) => {
                let found = format!("{error}; but for the files named below all are as they were before");
                let not_put_back = |path: &PathBuf| {
                    let kept = beside::kept(path);
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

/// A file on its way into a folder, or out of it. What was staged is gone when this is, whatever happens in between.
#[derive(Debug)]
pub struct Staged {
    /// where it goes
    pub path: PathBuf,
    change: Change,
}

/// What becomes of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Change {
    /// it is there already
    None,
    /// it replaces one whose owner this is; ours, if none is there
    Write(Owner),
    /// it is the record of the folder itself, which is always replaced, and counts as no file
    Record,
    /// it goes
    Remove,
}

impl Drop for Staged {
    fn drop(&mut self) {
        match self.change {
            Change::Write(_) | Change::Record => remove(&staged(&self.path)), // not there any more, if it was renamed
            Change::None | Change::Remove => {}
        }
    }
}

/// Writes a file next to its target in the folder; a file that is there already is left alone, whatever program has saved it.
///
/// # Errors
/// The folder does not take it.
pub fn stage(folder: &Folder, file: &File) -> Result<Staged, Refusal> {
    let path = folder.path_of(&file.name)?;
    let replaces = replaced(&path, &file.text).map_err(|error| Refusal::Failed(path.clone(), error))?;
    stage_at(path, &file.text, replaces.map_or(Change::None, Change::Write))
}

/// The same of the folder's own record, which replaces what is there.
///
/// # Errors
/// The folder does not take it.
pub fn record(folder: &Folder, file: &File) -> Result<Staged, Refusal> {
    let path = folder.path_of(&file.name)?;
    replaced(&path, &file.text).map_err(|error| Refusal::Failed(path.clone(), error))?;
    stage_at(path, &file.text, Change::Record)
}

/// A file that goes.
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
    // What is there already is somebody else's: it is neither followed nor written, and stays.
    let mut new = fs::OpenOptions::new().write(true).create_new(true).open(staged(&path)).map_err(failed)?;
    let on_its_way = Staged { path: path.clone(), change };
    new.write_all(text.as_bytes()).map_err(failed)?;
    Ok(on_its_way)
}

/// Renames all staged files to their targets, or none: not where one could not be staged, nor, unless `force` is set, where
/// one would replace a file that is not as it was generated.
///
/// # Errors
/// Why nothing was written; the folder's files are as they were before.
pub fn commit(folder: Folder, results: Vec<Result<Staged, Refusal>>, force: bool) -> Result<Written, Refusal> {
    let written = commit_in(&folder, results, force);
    drop(folder);
    written
}

/// The same, and the folder is held on.
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

/// Whose a file of this content is.
pub fn owner(content: &[u8]) -> Owner {
    // What is not UTF-8 is not what we wrote: with its replacement characters the checksum is wrong.
    match has_right_checksum(&String::from_utf8_lossy(content)) {
        Some(true) => Owner::Generated,
        Some(false) => Owner::Edited,
        // A crash of the host may leave it so.
        None if content.is_empty() => Owner::Generated,
        None => Owner::Other,
    }
}

/// Whose file a text is to replace. Through a link nothing is written, and nothing but a file is read.
fn replaced(path: &Path, text: &str) -> io::Result<Option<Owner>> {
    let found = match fs::symlink_metadata(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Some(Owner::Generated)),
        found => found?.file_type(),
    };
    // `load` refuses what is not a file, with or without a link before it.
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

/// Whether a thing of that type may be written anew at all.
fn is_writable(found: fs::FileType) -> io::Result<()> {
    match found {
        _ if found.is_symlink() => Err(io::Error::other("is a symbolic link, through which nothing is written")),
        _ if found.is_dir() => Err(ErrorKind::IsADirectory.into()),
        _ if !found.is_file() => Err(io::Error::other("is no regular file")),
        _ => Ok(()),
    }
}
