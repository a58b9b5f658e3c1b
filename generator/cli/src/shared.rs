//! The axes in shared files: the axes of the set, and those that other sets have generated into the same folder.
//!
//! With `--axis` these are the axes being written and those whose files already exist in the folder. TwinCAT's project file
//! then names existing files only, in any order of writing, and writing one axis again does not remove another:
//! docs/decisions/files.md.

use commands::words::made;
use generator::blocks::Designed;
use generator::diagnostics::Slashes;
use generator::generate::{axis_files, units};
use generator::pipeline::Set;
use generator::target::{self, Target, Unit};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::slice;

/// The depth of folders in which a target's files lie, below the output folder.
const DEPTH: usize = 2;

/// Largest number of axes that are named one by one; of more, only the number is printed.
const NAMED_AXES: usize = 10;

/// The axes of the set in the shared files of each target: usually all.
pub fn of_set<'s>(set: &'s Set, axes: &[String], targets: &[Target], out: &Path) -> Vec<Vec<Unit<'s>>> {
    let files = if axes.is_empty() { String::new() } else { names_below(out, DEPTH) };
    let of = |target: &Target| {
        let mut named = units(set);
        let has_shared = named.first().is_some_and(|unit| !(target.shared)(slice::from_ref(unit)).is_empty());
        if !axes.is_empty() && has_shared {
            let is_named = |of: &Designed| axes.contains(&of.axis.name) || is_there(of, target, out, &files);
            let is_named: Vec<bool> = set.axes.par_iter().map(is_named).collect();
            let mut is_named = is_named.into_iter();
            named.retain(|_| is_named.next() == Some(true));
        }
        named
    };
    targets.iter().map(of).collect()
}

/// The message if the shared files of a target, which name these axes, are not those of the whole set.
pub fn left_out(set: &Set, named: &[Unit<'_>], target: &Target, out: &Path) -> Option<String> {
    let is_named: BTreeSet<&str> = named.iter().map(|unit| unit.axis).collect();
    let whole = units(set);
    let mut with_all = named.to_vec();
    with_all.extend(whole.iter().filter(|unit| !is_named.contains(unit.axis)).cloned());
    if with_all.len() == named.len() || (target.shared)(named) == (target.shared)(&with_all) {
        return None;
    }
    let left_out: Vec<&str> = with_all[named.len()..].iter().map(|unit| unit.axis).collect();
    let axes = if left_out.len() > NAMED_AXES { format!("{} axes", left_out.len()) } else { left_out.join(", ") };
    let (target, out) = (target.name, out.slashes());
    Some(format!("{target}: the shared files leave out {axes}: their files are not in {out}\n"))
}

/// Whether the folder has all files of an axis, in any version.
fn is_there(designed: &Designed, target: &Target, out: &Path, files: &str) -> bool {
    // Generating an axis only for the names of its files takes time.
    if !files.contains(&target::stem(&designed.axis.name)) {
        return false;
    }
    let files = made(axis_files(designed, slice::from_ref(target)));
    !files.is_empty() && files.iter().all(|file| out.join(&file.name).is_file())
}

/// The names of all files in a folder and in `depth` levels of folders below it, one per line. Folders may be links.
fn names_below(folder: &Path, depth: usize) -> String {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let name = |entry: fs::DirEntry| match depth.checked_sub(1) {
        Some(depth) if entry.path().is_dir() => names_below(&entry.path(), depth),
        _ => entry.file_name().to_string_lossy().into_owned() + "\n",
    };
    entries.map(name).collect()
}
