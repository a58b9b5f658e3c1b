//! The names of files next to a target while it is being replaced, on the same file system. They contain the process id.

use std::fs;
use std::path::{Path, PathBuf};

const MARK: &str = ".axgen-";

pub(super) fn staged(path: &Path) -> PathBuf {
    next_to(path, "staged")
}

/// The old content, until all files have their new content.
pub(super) fn kept(path: &Path) -> PathBuf {
    next_to(path, "kept")
}

fn next_to(path: &Path, what: &str) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!("{MARK}{what}-{}", std::process::id()));
    path.with_file_name(name)
}

/// The role of a file with that name, `staged` or `kept`, and the name of its target; `None` if axgen did not create it.
pub(super) fn left_over(name: &str) -> Option<(&str, &str)> {
    let (target, rest) = name.rsplit_once(MARK)?;
    let (what, process) = rest.split_once('-')?;
    let is_number = !process.is_empty() && process.bytes().all(|byte| byte.is_ascii_digit());
    let is_ours = what == "staged" || what == "kept" && !target.is_empty();
    (is_number && is_ours).then_some((what, target))
}

/// Removes one of axgen's files. It makes no difference to the caller if the file does not exist or cannot be removed.
pub(super) fn remove(path: &Path) {
    let _ = fs::remove_file(path);
}
