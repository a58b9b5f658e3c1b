//! Puts files into a folder: staged beside their targets, then renamed; all of them or none.

use crate::digest::digest;
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

/// Writes the files into the folder, which is made if need be. A file that is there already, to the byte, is left alone.
///
/// # Errors
/// A file that was edited by hand, unless `force` is set; or the folder does not take them. Either way the folder is as it
/// was before.
pub fn write(folder: &Path, files: &[File], force: bool) -> Result<Written, Refusal> {
    let mut changed = Vec::new();
    let mut edited = Vec::new();
    for file in files {
        let path = folder.join(&file.name);
        match fs::read(&path) {
            Ok(old) if old == file.text.as_bytes() => {}
            Ok(old) => {
                if edited_by_hand(&old) {
                    edited.push(path.clone());
                }
                changed.push((path, file));
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => changed.push((path, file)),
            Err(error) => return Err(Refusal::Failed(path, error)),
        }
    }
    if !edited.is_empty() && !force {
        return Err(Refusal::Edited(edited));
    }
    fs::create_dir_all(folder).map_err(|error| Refusal::Failed(folder.to_owned(), error))?;
    stage(&changed)?;
    replace(&changed)?;
    Ok(Written { changed: changed.len(), unchanged: files.len() - changed.len() })
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
fn stage(files: &[(PathBuf, &File)]) -> Result<(), Refusal> {
    for (position, (path, file)) in files.iter().enumerate() {
        if let Err(error) = fs::write(staged(path), &file.text) {
            for (path, _) in &files[..=position] {
                remove(&staged(path));
            }
            return Err(Refusal::Failed(path.clone(), error));
        }
    }
    Ok(())
}

/// Renames every staged file; on a failure puts back what was there.
fn replace(files: &[(PathBuf, &File)]) -> Result<(), Refusal> {
    for (position, (path, _)) in files.iter().enumerate() {
        let result = keep(path).and_then(|()| fs::rename(staged(path), path));
        if let Err(error) = result {
            for (path, _) in files[..=position].iter().rev() {
                if fs::rename(kept(path), path).is_err() && staged(path).exists().eq(&false) {
                    remove(path); // it was not there before
                }
            }
            for (path, _) in files {
                remove(&staged(path));
            }
            return Err(Refusal::Failed(path.clone(), error));
        }
    }
    for (path, _) in files {
        remove(&kept(path));
    }
    Ok(())
}

/// Moves an old file aside.
fn keep(path: &Path) -> io::Result<()> {
    match fs::rename(path, kept(path)) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

/// Removes a file of ours. That it may not be there, or cannot be removed, changes nothing for the caller.
fn remove(path: &Path) {
    let _ = fs::remove_file(path);
}
