//! The output folder: created if necessary, locked by one process at a time, and cleared of files of a killed process.

use super::Refusal;
use super::temporary::{left_over, remove};
use crate::config;
use crate::digest::has_right_checksum;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// A folder that is locked while this value exists. Folders that were created for it are removed if they stay empty.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    /// the folder itself, opened and locked; `None` if the system cannot lock folders
    lock: Option<fs::File>,
    below: Mutex<Below>,
}

#[derive(Debug, Default)]
struct Below {
    ready: BTreeSet<PathBuf>,
    /// created folders, each once: a folder that another run creates after the removal belongs to that run
    made: BTreeSet<PathBuf>,
    /// files with the name of one that a killed run leaves next to a target; the target decides whose they are
    left_over: LeftOver,
}

/// The leftover files of each target, and whether each has its old content.
type LeftOver = BTreeMap<PathBuf, Vec<(PathBuf, bool)>>;

impl Drop for Folder {
    fn drop(&mut self) {
        let below = self.below.get_mut().unwrap_or_else(PoisonError::into_inner);
        // A folder comes after its parents. The removal fails, as intended, if the folder contains a file.
        for made in below.made.iter().rev() {
            let is_own = *made == self.path && self.lock.as_ref().is_some_and(|own| is_at(own, made));
            // Another run may hold the folder now, or wait for it: that run then creates it again.
            let lock = if is_own { Ok(None) } else { lock(made, Wait::No) };
            let _ = lock.and_then(|_lock| fs::remove_dir(made));
        }
    }
}

/// Number of attempts if the folder vanishes between creation and locking, because another run created it, failed and
/// removed it.
const TRIES: usize = 100;

/// Creates the folder if necessary, waits until no other process holds it, and locks it.
///
/// # Errors
/// It cannot be created or opened.
pub fn open(path: &Path) -> Result<Folder, Refusal> {
    let mut folder = Folder { path: path.to_owned(), lock: None, below: Mutex::default() };
    let mut last = ErrorKind::NotFound.into();
    for _ in 0..TRIES {
        let below = folder.below.get_mut().unwrap_or_else(PoisonError::into_inner);
        match make(path, &mut below.made).and_then(|()| lock(path, Wait::Yes)) {
            Ok(lock) => {
                clear(path, lock.is_some(), &mut below.left_over);
                folder.lock = lock;
                return Ok(folder);
            }
            // Another run may remove the folder, or one of its parents, during the creation.
            Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::AlreadyExists) && !path.is_file() => {
                last = error;
            }
            Err(error) => return Err(Refusal::Failed(path.to_owned(), error)),
        }
    }
    Err(Refusal::Failed(path.to_owned(), last))
}

impl Folder {
    /// The path of a file with that name. Its folder exists afterwards, without leftover files of a killed run next to the
    /// target.
    ///
    /// # Errors
    /// Its folder cannot be created.
    pub fn path_of(&self, name: &str) -> Result<PathBuf, Refusal> {
        let path = self.path.join(name);
        let mut below = self.below.lock().unwrap_or_else(PoisonError::into_inner);
        if name.contains('/')
            && let Some(parent) = path.parent()
            && !below.ready.contains(parent)
        {
            make(parent, &mut below.made).map_err(|error| Refusal::Failed(parent.to_owned(), error))?;
            clear(parent, self.lock.is_some(), &mut below.left_over);
            below.ready.insert(parent.to_owned());
        }
        let left_over = below.left_over.remove(&path);
        left_over.iter().flatten().for_each(|(left_over, is_kept)| settle(left_over, *is_kept, &path));
        Ok(path)
    }

    /// Removes the parents of a removed file, up to this folder, as far as they are empty.
    pub(super) fn clear_above(&self, path: &Path) {
        let above = path.ancestors().skip(1).take_while(|above| *above != self.path);
        let _ = above.map(fs::remove_dir).take_while(Result::is_ok).count();
    }
}

/// Removes the files of a killed run, recognised by their checksums, and notes files that only have such a name. Only if the
/// folder is locked: no running process then owns files next to a target.
fn clear(folder: &Path, is_held: bool, noted: &mut LeftOver) {
    let entries = is_held.then(|| fs::read_dir(folder)).into_iter().flatten().flatten().flatten();
    for entry in entries.filter(|entry| entry.file_type().is_ok_and(|found| found.is_file())) {
        let name = entry.file_name();
        let Some((what, target)) = name.to_str().and_then(left_over) else { continue };
        let (path, is_kept, target) = (entry.path(), what == "kept", folder.join(target));
        let is_ours = |content: Vec<u8>| has_right_checksum(&String::from_utf8_lossy(&content)) == Some(true);
        match config::load(&path).is_ok_and(is_ours) {
            true => settle(&path, is_kept, &target),
            false => noted.entry(target).or_default().push((path, is_kept)),
        }
    }
}

/// Restores the old content of a target that has none, or removes the file next to it.
fn settle(left_over: &Path, is_kept: bool, target: &Path) {
    if is_kept && fs::symlink_metadata(target).is_err() {
        let _ = fs::rename(left_over, target);
    } else {
        remove(left_over);
    }
}

/// Creates a folder with its parents, and notes the created ones.
fn make(path: &Path, made: &mut BTreeSet<PathBuf>) -> io::Result<()> {
    let missing: Vec<&Path> = path.ancestors().take_while(|above| fs::symlink_metadata(above).is_err()).collect();
    made.extend(missing.iter().filter(|above| !above.as_os_str().is_empty()).map(|above| above.to_path_buf()));
    fs::create_dir_all(path)
}

/// What to do with a folder that another process holds.
#[derive(Clone, Copy)]
enum Wait {
    Yes,
    /// leave it: the error `WouldBlock`
    No,
}

/// Locks the folder itself, so that no lock file is left in it: the system unlocks it when the process ends for any reason.
/// Returns `None` if folders cannot be opened (Windows) or locked (some network file systems).
fn lock(path: &Path, wait: Wait) -> io::Result<Option<fs::File>> {
    let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
    let folder = match fs::File::open(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Err(error),
        Err(_) => return Ok(None),
        Ok(folder) => folder,
    };
    let locked = match wait {
        Wait::Yes => folder.lock().map_err(TryLockError::Error),
        Wait::No => folder.try_lock(),
    };
    match locked {
        Err(TryLockError::WouldBlock) => Err(ErrorKind::WouldBlock.into()),
        Err(TryLockError::Error(_)) => Ok(None),
        Ok(()) if is_at(&folder, path) => Ok(Some(folder)),
        Ok(()) => Err(ErrorKind::NotFound.into()),
    }
}

/// Whether an open folder is still the one at the path: it may have been removed while this process waited for it.
#[cfg(unix)]
fn is_at(folder: &fs::File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (folder.metadata(), fs::metadata(path)) {
        (Ok(held), Ok(found)) => (held.dev(), held.ino()) == (found.dev(), found.ino()),
        _ => false,
    }
}

#[cfg(not(unix))]
fn is_at(_: &fs::File, path: &Path) -> bool {
    path.is_dir()
}
