//! Puts files into a folder: staged beside their targets, then renamed; all of them or none.

use crate::digest::is_sealed;
use crate::target::File;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// What was done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// files that are new or have changed
    pub changed: usize,
    /// files that were there already, to the byte
    pub unchanged: usize,
}

/// Why nothing was written.
#[derive(Debug)]
pub enum Refusal {
    /// these files were changed by hand after they had been generated
    Edited(Vec<PathBuf>),
    /// the folder does not take them
    Failed(PathBuf, io::Error),
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Edited(paths) => {
                for path in paths {
                    writeln!(f, "{}: was changed by hand after it had been generated", path.display())?;
                }
                write!(f, "nothing was written; move the changes to the set, or overwrite them with --force")
            }
            Self::Failed(path, error) => write!(f, "{}: {error}; nothing was written", path.display()),
        }
    }
}

/// A file on its way into a folder.
#[derive(Debug)]
pub struct Staged {
    /// where it goes
    pub path: PathBuf,
    /// what has to be done for that
    kind: Kind,
}

/// What has to be done for a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// nothing: it is there, to the byte
    Unchanged,
    /// none is there
    New,
    /// an older one is there
    Replaces,
    /// an older one is there that was changed by hand
    ReplacesEdited,
}

/// Writes a file beside its target in the folder, which is there; a file that is there already, to the byte, is left alone.
///
/// # Errors
/// The folder does not take it.
pub fn stage(folder: &Path, file: &File) -> Result<Staged, Refusal> {
    let path = folder.join(&file.name);
    if let Some(parent) = path.parent()
        && file.name.contains('/')
        && let Err(error) = fs::create_dir_all(parent)
    {
        return Err(Refusal::Failed(parent.to_owned(), error));
    }
    let kind = match fs::read(&path) {
        Ok(old) if old == file.text.as_bytes() => Kind::Unchanged,
        Ok(old) if edited_by_hand(&old) => Kind::ReplacesEdited,
        Ok(_) => Kind::Replaces,
        Err(error) if error.kind() == io::ErrorKind::NotFound => Kind::New,
        Err(error) => return Err(Refusal::Failed(path, error)),
    };
    if kind != Kind::Unchanged
        && let Err(error) = fs::write(staged(&path), &file.text)
    {
        remove(&staged(&path));
        return Err(Refusal::Failed(path, error));
    }
    Ok(Staged { path, kind })
}

/// Renames all staged files to their targets, or none: not where one could not be staged, nor, unless `force` is set, where
/// one would replace a file that was changed by hand.
///
/// # Errors
/// Why nothing was written; the folder's files are as they were before.
pub fn commit(results: Vec<Result<Staged, Refusal>>, force: bool) -> Result<Written, Refusal> {
    let mut refusal = None;
    let mut files = Vec::new();
    for result in results {
        match result {
            Ok(file) => files.push(file),
            Err(error) => refusal = refusal.or(Some(error)),
        }
    }
    let edited = files.iter().filter(|file| file.kind == Kind::ReplacesEdited && !force);
    let edited: Vec<PathBuf> = edited.map(|file| file.path.clone()).collect();
    let refusal = refusal.or_else(|| (!edited.is_empty()).then_some(Refusal::Edited(edited)));
    let all = files.len();
    files.retain(|file| file.kind != Kind::Unchanged);
    if let Some(refusal) = refusal {
        files.iter().for_each(|file| remove(&staged(&file.path)));
        return Err(refusal);
    }
    replace(&files)?;
    Ok(Written { changed: files.len(), unchanged: all - files.len() })
}

/// Whether a file that was generated has another content than it was sealed with.
#[must_use]
pub fn edited_by_hand(content: &[u8]) -> bool {
    std::str::from_utf8(content).is_ok_and(|text| is_sealed(text) == Some(false))
}

fn staged(path: &Path) -> PathBuf {
    beside(path, "staged")
}

fn kept(path: &Path) -> PathBuf {
    beside(path, "kept")
}

/// A name beside the target, on the same file system.
fn beside(path: &Path, what: &str) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".axgen-{what}-{}", std::process::id()));
    path.with_file_name(name)
}

/// Renames every staged file; on a failure puts back what was there.
fn replace(files: &[Staged]) -> Result<(), Refusal> {
    for (position, Staged { path, kind }) in files.iter().enumerate() {
        let aside = if *kind == Kind::New { Ok(()) } else { fs::rename(path, kept(path)) };
        if let Err(error) = aside.and_then(|()| fs::rename(staged(path), path)) {
            files[..=position].iter().rev().for_each(put_back);
            files.iter().for_each(|file| remove(&staged(&file.path)));
            return Err(Refusal::Failed(path.clone(), error));
        }
    }
    for file in files.iter().filter(|file| file.kind != Kind::New) {
        remove(&kept(&file.path));
    }
    Ok(())
}

/// Undoes the renaming of one file, as far as it had come.
fn put_back(file: &Staged) {
    let renamed = !staged(&file.path).exists();
    if file.kind != Kind::New {
        let _ = fs::rename(kept(&file.path), &file.path); // fails where the old file never left its place
    } else if renamed {
        remove(&file.path);
    }
}

/// Removes a file of ours. That it may not be there, or cannot be removed, changes nothing for the caller.
fn remove(path: &Path) {
    let _ = fs::remove_file(path);
}
