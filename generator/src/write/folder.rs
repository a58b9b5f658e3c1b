//! The folder that files go into: made if need be, held by one process at a time, cleared of what a killed one left.

use super::Refusal;
use super::beside::{left_over, remove};
use crate::config;
use crate::digest::has_right_checksum;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, TryLockError};
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
    /// those that were not there before, each once: what another run makes after its removal is that run's
    made: BTreeSet<PathBuf>,
    /// files that have the name of one that a killed run left next to a target; whose they are the target tells
    left_over: LeftOver,
}

/// The left-over files of each target, and which of them have its old content.
type LeftOver = BTreeMap<PathBuf, Vec<(PathBuf, bool)>>;

impl Drop for Folder {
    fn drop(&mut self) {
        let below = self.below.get_mut().unwrap_or_else(PoisonError::into_inner);
        // A folder comes after those above it. The removal fails where a file is in it, and should.
        for made in below.made.iter().rev() {
            let is_own = *made == self.path && self.lock.as_ref().is_some_and(|own| is_at(own, made));
            // Another run may have come to hold it, or may wait for it: that one then makes it again.
            let lock = if is_own { Ok(None) } else { lock(made, Wait::No) };
            let _ = lock.and_then(|_lock| fs::remove_dir(made));
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
        match make(path, &mut below.made).and_then(|()| lock(path, Wait::Yes)) {
            Ok(lock) => {
                clear(path, lock.is_some(), &mut below.left_over);
                folder.lock = lock;
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
    /// Where a file of that name goes; its folder is there afterwards, and nothing of a killed run next to it.
    ///
    /// # Errors
    /// Its folder cannot be made.
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

    /// Removes the folders above a file that was removed, up to this one, as far as nothing else is in them.
    pub(super) fn clear_above(&self, path: &Path) {
        let above = path.ancestors().skip(1).take_while(|above| *above != self.path);
        let _ = above.map(fs::remove_dir).take_while(Result::is_ok).count();
    }
}

/// Removes what a killed run left, as its checksum says, and notes what only has the name of such a file. Only if the folder is
/// held: what lies next to a target then belongs to nobody.
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

/// Gives a target its old content back, if it has none, or removes what is next to it.
fn settle(left_over: &Path, is_kept: bool, target: &Path) {
    if is_kept && fs::symlink_metadata(target).is_err() {
        let _ = fs::rename(left_over, target);
    } else {
        remove(left_over);
    }
}

/// Makes a folder with those above it, and notes which.
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

/// Locks the folder itself, so that no file of a lock's own is left in it: the system unlocks it when the process ends,
/// however that comes. Gives none where folders cannot be opened (Windows) or locked (some network file systems).
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
