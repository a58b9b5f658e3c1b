//! `generate --axis`: what the files that all axes of a set share name, where only some of the axes are written.
//!
//! They name the axes that are written, and those whose files are in the folder already: what TwinCAT's project file names is
//! there, whichever axes were written one by one, and writing one anew takes none out: docs/decisions/0017-single-axes.md.

use generator::blocks::Designed;
use generator::diagnostics::Slashes;
use generator::generate::{axis_files, units};
use generator::pipeline::Set;
use generator::target::{self, Target};
use rayon::prelude::*;
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::slice;

/// The folders that a file of a target lies in, below the output folder.
const DEPTH: usize = 2;

/// Axes that are named one by one; of more, only their number is said.
const NAMED_AXES: usize = 10;

/// The set as the shared files of each target name it: mostly the whole set itself.
pub fn named<'s>(set: &'s Set, axes: &[String], targets: &[Target], out: &Path) -> Vec<Cow<'s, Set>> {
    let files = if axes.is_empty() { String::new() } else { names_below(out, DEPTH) };
    let of = |target: &Target| {
        let has_shared = units(set).first().is_some_and(|unit| !(target.shared)(slice::from_ref(unit)).is_empty());
        if axes.is_empty() || !has_shared {
            return Cow::Borrowed(set);
        }
        let is_named = |of: &&Designed| axes.contains(&of.axis.name) || is_there(of, target, out, &files);
        let named: Vec<&Designed> = set.axes.par_iter().filter(is_named).collect();
        if named.len() == set.axes.len() {
            return Cow::Borrowed(set);
        }
        let axes = named.into_iter().cloned().collect();
        Cow::Owned(Set { targets: set.targets.clone(), axes, foreign: set.foreign })
    };
    targets.iter().map(of).collect()
}

/// What is to be said where the shared files of a target are not those of the whole set.
pub fn left_out(set: &Set, named: &Set, target: &Target, out: &Path) -> Option<String> {
    if named.axes.len() == set.axes.len() || (target.shared)(&units(named)) == (target.shared)(&units(set)) {
        return None;
    }
    let is_named: BTreeSet<&str> = names(named).collect();
    let left_out: Vec<&str> = names(set).filter(|name| !is_named.contains(name)).collect();
    let axes = if left_out.len() > NAMED_AXES { format!("{} axes", left_out.len()) } else { left_out.join(", ") };
    let (target, out) = (target.name, out.slashes());
    Some(format!("{target}: the shared files leave out {axes}: their files are not in {out}\n"))
}

fn names(set: &Set) -> impl Iterator<Item = &str> {
    set.axes.iter().map(|of| of.axis.name.as_str())
}

/// Whether the folder has all files of an axis, as they are now or were once.
fn is_there(designed: &Designed, target: &Target, out: &Path, files: &str) -> bool {
    // To make an axis only for the names of its files takes its time.
    if !files.contains(&target::stem(&designed.axis.name)) {
        return false;
    }
    let files = axis_files(designed, slice::from_ref(target));
    let files = files.unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"));
    !files.is_empty() && files.iter().all(|file| out.join(&file.name).is_file())
}

/// The names of all files in a folder and so many folders below it, a line each. Folders may be links.
fn names_below(folder: &Path, depth: usize) -> String {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let name = |entry: fs::DirEntry| match depth.checked_sub(1) {
        Some(depth) if entry.path().is_dir() => names_below(&entry.path(), depth),
        _ => entry.file_name().to_string_lossy().into_owned() + "\n",
    };
    entries.map(name).collect()
}
