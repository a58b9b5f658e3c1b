//! The command `diff`: the effect of a change between two sets on the machine.

use generator::config::{ListOptions, Load, is_set};
use generator::diagnostics::Report;
use generator::diff;
use generator::pipeline::{self, Set};
use serde::Serialize;
use std::path::Path;

/// The differences.
#[derive(Clone, Debug, Serialize)]
pub struct Changes {
    pub lines: Vec<String>,
    /// whether a block does something else, is new or no longer exists
    pub differ: bool,
}

/// A version of a set, with its messages.
pub type Version = (Option<Set>, Report);

/// How a version is read.
type Reader = fn(&Path, &ListOptions, Load<'_>) -> Version;

/// Reads two versions of axes. `options` are for axis lists. An unstable version can be compared, too: usually with one that
/// is stable.
pub fn read(files: [&Path; 2], options: &ListOptions, load: Load<'_>) -> [Version; 2] {
    read_by([pipeline::read_to_look_at; 2], files, options, load)
}

/// Reads the block on the machine, and the set that will act on it: a set that is enabled and unstable is refused.
pub fn read_for_set(files: [&Path; 2], options: &ListOptions, load: Load<'_>) -> [Version; 2] {
    read_by([pipeline::read_to_look_at, pipeline::read_with], files, options, load)
}

fn read_by(by: [Reader; 2], files: [&Path; 2], options: &ListOptions, load: Load<'_>) -> [Version; 2] {
    let some_list = files.iter().any(|file| !is_set(file));
    let none = ListOptions::default();
    let options = files.map(|file| if is_set(file) && some_list { &none } else { options });
    std::array::from_fn(|k| by[k](files[k], options[k], load))
}

/// Compares two versions. Two lists are versions of one axis, even if their file names differ.
#[must_use]
pub fn diff(files: [&Path; 2], mut before: Set, after: &Set) -> Changes {
    if let ([old], [new], false) =
        (before.axes.as_mut_slice(), after.axes.as_slice(), files.iter().any(|file| is_set(file)))
    {
        old.axis.name.clone_from(&new.axis.name);
    }
    let (lines, differ) = diff::lines(&before.axes, &after.axes);
    Changes { lines, differ }
}
