//! Puts files into a folder: staged beside their targets, then renamed; all of them or none.

use crate::digest::digest;
use crate::target::File;
use rayon::prelude::*;
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

/// A file that has to be written.
struct Change<'f> {
    path: PathBuf,
    text: &'f str,
    /// whether an older one is there
    replaces: bool,
    /// whether that one was changed by hand
    edited: bool,
}

/// Writes the files into the folder, which is made if need be. A file that is there already, to the byte, is left alone.
///
/// # Errors
/// A file that was edited by hand, unless `force` is set; or the folder does not take them. Either way the folder is as it
/// was before.
pub fn write(folder: &Path, files: &[File], force: bool) -> Result<Written, Refusal> {
    let changes: Result<Vec<_>, Refusal> = files.par_iter().map(|file| change(folder, file)).collect();
    let changes: Vec<Change<'_>> = changes?.into_iter().flatten().collect();
    if !force && changes.iter().any(|change| change.edited) {
        let edited = changes.into_iter().filter(|change| change.edited);
        return Err(Refusal::Edited(edited.map(|change| change.path).collect()));
    }
    fs::create_dir_all(folder).map_err(|error| Refusal::Failed(folder.to_owned(), error))?;
    stage(&changes)?;
    replace(&changes)?;
    Ok(Written { changed: changes.len(), unchanged: files.len() - changes.len() })
}

/// What has to be done for a file; nothing, if it is there to the byte.
fn change<'f>(folder: &Path, file: &'f File) -> Result<Option<Change<'f>>, Refusal> {
    let (path, text) = (folder.join(&file.name), file.text.as_str());
    match fs::read(&path) {
        Ok(old) if old == text.as_bytes() => Ok(None),
        Ok(old) => Ok(Some(Change { path, text, replaces: true, edited: edited_by_hand(&old) })),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            Ok(Some(Change { path, text, replaces: false, edited: false }))
        }
        Err(error) => Err(Refusal::Failed(path, error)),
    }
}

/// Whether a generated file's body is no longer the one that its digest was made of.
#[must_use]
pub fn edited_by_hand(content: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(content) else { return false };
    let digest_of_body = text.lines().find_map(|line| line.trim_start_matches([' ', '*']).strip_prefix("body"));
    let body = text.split_once(" */\n").map(|(_, body)| body);
    match (digest_of_body, body) {
        (Some(stated), Some(body)) => stated.trim() != digest(body.strip_suffix('\n').unwrap_or(body).as_bytes()),
        _ => false,
    }
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

/// Writes every file beside its target; on a failure removes what it has written.
fn stage(changes: &[Change<'_>]) -> Result<(), Refusal> {
    let staged = changes.par_iter().try_for_each(|change| {
        let written = fs::write(staged(&change.path), change.text);
        written.map_err(|error| Refusal::Failed(change.path.clone(), error))
    });
    if staged.is_err() {
        remove_staged(changes);
    }
    staged
}

/// Renames every staged file; on a failure puts back what was there.
fn replace(changes: &[Change<'_>]) -> Result<(), Refusal> {
    for (position, Change { path, replaces, .. }) in changes.iter().enumerate() {
        let aside = if *replaces { fs::rename(path, kept(path)) } else { Ok(()) };
        if let Err(error) = aside.and_then(|()| fs::rename(staged(path), path)) {
            for done in changes[..=position].iter().rev() {
                put_back(done);
            }
            remove_staged(changes);
            return Err(Refusal::Failed(path.clone(), error));
        }
    }
    for change in changes.iter().filter(|change| change.replaces) {
        remove(&kept(&change.path));
    }
    Ok(())
}

/// Undoes the renaming of one file, as far as it had come.
fn put_back(change: &Change<'_>) {
    let renamed = !staged(&change.path).exists();
    if change.replaces {
        let _ = fs::rename(kept(&change.path), &change.path); // fails where the old file never left its place
    } else if renamed {
        remove(&change.path);
    }
}

fn remove_staged(changes: &[Change<'_>]) {
    for change in changes {
        remove(&staged(&change.path));
    }
}

/// Removes a file of ours. That it may not be there, or cannot be removed, changes nothing for the caller.
fn remove(path: &Path) {
    let _ = fs::remove_file(path);
}
