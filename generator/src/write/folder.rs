//! The folder that files go into: made if need be, held by one process at a time, cleared of what a killed one left.

use super::Refusal;
use super::beside::{left_over, remove};
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// A folder that is held until this is gone. Folders that were made for it go again if they stay empty.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    /// the folder itself, opened and locked; none where the system locks no folders
    lock: Option<fs::File>,
    below: Mutex<Below>,
}

#[derive(Debug, Default)]
struct Below {
    ready: BTreeSet<PathBuf>,
    /// those that were not there before, in the order of their making
    made: Vec<PathBuf>,
}

impl Drop for Folder {
    fn drop(&mut self) {
        let below = self.below.get_mut().unwrap_or_else(PoisonError::into_inner);
        for made in below.made.iter().rev() {
            let _ = fs::remove_dir(made); // fails where a file is in it, and should
        }
    }
}

/// So often the folder may vanish between its making and its locking: another run made it, failed and took it away.
const TRIES: usize = 100;

/// Makes the folder if need be, waits until no other process holds it, and holds it.
///
/// # Errors
/// It cannot be made, or not be opened.
pub fn open(path: &Path) -> Result<Folder, Refusal> {
    let mut folder = Folder { path: path.to_owned(), lock: None, below: Mutex::default() };
    let mut last = ErrorKind::NotFound.into();
    for _ in 0..TRIES {
        let below = folder.below.get_mut().unwrap_or_else(PoisonError::into_inner);
        match make(path, &mut below.made).and_then(|()| lock(path)) {
            Ok(lock) => {
                folder.lock = lock;
                folder.clear(path);
                return Ok(folder);
            }
            // Another run may take the folder, or one above it, away while it is being made.
            Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::AlreadyExists) && !path.is_file() => {
                last = error;
            }
            Err(error) => return Err(Refusal::Failed(path.to_owned(), error)),
        }
    }
    Err(Refusal::Failed(path.to_owned(), last))
}

impl Folder {
    /// Where a file of that name goes; its folder is there afterwards.
    pub(super) fn path_of(&self, name: &str) -> Result<PathBuf, Refusal> {
        let path = self.path.join(name);
        if name.contains('/')
            && let Some(parent) = path.parent()
        {
            let mut below = self.below.lock().unwrap_or_else(PoisonError::into_inner);
            if !below.ready.contains(parent) {
                make(parent, &mut below.made).map_err(|error| Refusal::Failed(parent.to_owned(), error))?;
                self.clear(parent);
                below.ready.insert(parent.to_owned());
            }
        }
        Ok(path)
    }

    /// Removes what a killed run left. Only if this is held: what lies beside a target then belongs to nobody.
    fn clear(&self, folder: &Path) {
        if self.lock.is_none() {
            return;
        }
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            match entry.file_name().to_str().and_then(left_over) {
                Some(("kept", target)) if fs::symlink_metadata(folder.join(target)).is_err() => {
                    let _ = fs::rename(entry.path(), folder.join(target));
                }
                Some(_) => remove(&entry.path()),
                None => {}
            }
        }
    }
}

/// Makes a folder with those above it, and notes which.
fn make(path: &Path, made: &mut Vec<PathBuf>) -> io::Result<()> {
    let missing: Vec<&Path> = path.ancestors().take_while(|above| fs::symlink_metadata(above).is_err()).collect();
    made.extend(missing.iter().rev().filter(|above| !above.as_os_str().is_empty()).map(|above| above.to_path_buf()));
    fs::create_dir_all(path)
}

/// Locks the folder itself, so that no file of a lock's own is left in it: the system unlocks it when the process ends,
/// however that comes. Gives none where folders cannot be opened (Windows) or locked (some network file systems).
fn lock(path: &Path) -> io::Result<Option<fs::File>> {
    let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
    let folder = match fs::File::open(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Err(error),
        Err(_) => return Ok(None),
        Ok(folder) => folder,
    };
    if folder.lock().is_err() {
        return Ok(None);
    }
    if is_at(&folder, path) { Ok(Some(folder)) } else { Err(ErrorKind::NotFound.into()) }
}

/// Whether an open folder is still the one at the path: it may have been removed while we waited for it.
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
