//! One requested file, by its path: staged next to it, then renamed. The caller decides which files it may replace.

use super::is_writable;
use super::temporary::{left_over, remove, staged};
use crate::diagnostics::Slashes;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// The existing files that may be replaced; always only regular files.
#[derive(Clone, Copy)]
pub enum Replace<'r> {
    None,
    /// empty files, and those whose first bytes satisfy this
    Those(&'r dyn Fn(&[u8]) -> bool),
    All,
}

/// A file next to its target; removed together with this value in any case.
#[derive(Debug)]
pub struct One {
    path: PathBuf,
    replaces: bool,
    /// the file next to it, locked while in use: otherwise another run would treat it as a leftover
    lock: Option<File>,
}

impl Drop for One {
    fn drop(&mut self) {
        remove(&staged(&self.path)); // already gone if it was renamed
    }
}

/// Whether there is a file, which may be replaced.
///
/// # Errors
/// `AlreadyExists`: it must not be replaced. It is a link or not a regular file, or the system does not allow reading it.
pub fn is_replaced(path: &Path, replace: Replace<'_>) -> io::Result<bool> {
    match fs::symlink_metadata(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(false),
        found => is_writable(found?.file_type())?,
    }
    let is_allowed = match replace {
        Replace::None => false,
        Replace::All => true,
        Replace::Those(begins) => {
            let mut head = Vec::new();
            File::open(path)?.take(1 << 16).read_to_end(&mut head)?;
            head.is_empty() || begins(&head)
        }
    };
    if is_allowed { Ok(true) } else { Err(ErrorKind::AlreadyExists.into()) }
}

/// Writes the bytes next to their target.
///
/// # Errors
/// As [`is_replaced`], or the folder does not accept them. Nothing is left then.
pub fn stage_one(path: &Path, bytes: &[u8], replace: Replace<'_>) -> io::Result<One> {
    let replaces = is_replaced(path, replace)?;
    clear(path);
    let mut file = OpenOptions::new().write(true).create_new(true).open(staged(path)).map_err(|error| {
        let is_there = error.kind() == ErrorKind::AlreadyExists;
        if is_there { io::Error::other(format!("{} is in the way", staged(path).slashes())) } else { error }
    })?;
    // Not every system can lock files; if it cannot, the files of a killed run stay.
    let _ = file.lock();
    let mut one = One { path: path.to_owned(), replaces, lock: None };
    file.write_all(bytes).and_then(|()| file.sync_all())?;
    one.lock = Some(file);
    Ok(one)
}

/// Removes the leftover of a killed run next to the target: a file with this process's name for it that no process holds. In
/// containers all processes may have the same id.
fn clear(path: &Path) {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let target = path.file_name().unwrap_or_default();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let is_ours = name.to_str().and_then(left_over).is_some_and(|(what, of)| what == "staged" && target == of);
        let is_file = entry.file_type().is_ok_and(|found| found.is_file());
        if is_ours && is_file && File::open(entry.path()).is_ok_and(|file| file.try_lock().is_ok()) {
            remove(&entry.path());
        }
    }
}

impl One {
    /// Moves the complete file to its place.
    ///
    /// # Errors
    /// `AlreadyExists`: a file was created there in the meantime. Otherwise the folder does not accept it.
    pub fn commit(self) -> io::Result<()> {
        let staged = staged(&self.path);
        // Unlike a renamed file, a hard link never replaces a file. Some file systems do not support it.
        if !self.replaces && fs::hard_link(&staged, &self.path).is_ok() {
            return Ok(());
        }
        is_replaced(&self.path, if self.replaces { Replace::All } else { Replace::None })?;
        fs::rename(&staged, &self.path)
    }
}
