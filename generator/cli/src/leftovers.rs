//! The leftovers of a folder: files that the set generated earlier and no longer generates; and the manifest after the run.

use crate::recorded::Recorded;
use commands::words::counted;
use generator::codes;
use generator::config;
use generator::diagnostics::{Diagnostic, Place, Report, Slashes};
use generator::generate::PAGE;
use generator::manifest::{Entry, Manifest};
use generator::pipeline::Set;
use generator::write::{self, Owner};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The scope of a run: with `--axis` and `--target` it judges only files of these.
pub struct Scope<'s> {
    /// the axes of the set, or of the project from which `--name` selects one
    known: BTreeSet<&'s str>,
    /// empty for all
    axes: &'s [String],
    /// empty for all
    targets: &'s [String],
}

impl<'s> Scope<'s> {
    pub fn new(set: &'s Set, axes: &'s [String], targets: &'s [String], others: &'s [String]) -> Self {
        let own = set.axes.iter().map(|of| of.axis.name.as_str());
        Self { known: own.chain(others.iter().map(String::as_str)).collect(), axes, targets }
    }

    /// Whether the run covers the whole set.
    pub fn is_whole(&self) -> bool {
        self.axes.is_empty() && self.targets.is_empty()
    }

    /// Whether a file that this set has generated would be generated again, if the set still had its axis. A removed axis is
    /// in the scope of every run, because it is not one of the other axes.
    fn covers(&self, entry: &Entry) -> bool {
        let has_target = self.targets.is_empty() || entry.target == PAGE || self.targets.contains(&entry.target);
        match &entry.axis {
            Some(axis) if !self.known.contains(axis.as_str()) => true,
            Some(axis) => has_target && (self.axes.is_empty() || self.axes.contains(axis)),
            None => has_target && self.axes.is_empty(),
        }
    }

    /// The targets of the set's files in a folder that the run no longer generates.
    pub fn dropped<'r>(&self, recorded: &'r Recorded, is_made: impl Fn(&str) -> bool) -> Vec<&'r str> {
        let dropped = recorded.targets().into_iter().filter(|target| !is_made(target));
        if self.is_whole() { dropped.collect() } else { Vec::new() }
    }
}

/// The files in a folder besides those that the run generates.
#[derive(Debug, Default)]
pub struct Leftovers {
    /// files to be removed: generated and not edited
    pub removed: Vec<String>,
    /// files that stay although they are no longer generated: they were edited or replaced by others
    pub kept: Vec<(String, Owner)>,
    /// generated files that no known set generates
    pub unlisted: Vec<String>,
    /// number of files of another set that this run now generates, by set
    pub taken: BTreeMap<String, usize>,
    /// number of other files of another set, by set
    pub others: BTreeMap<String, usize>,
    /// the manifest while files are replaced: it names every generated file even if the run is killed
    pub meanwhile: Manifest,
    /// the manifest afterwards
    pub after: Manifest,
}

impl Leftovers {
    /// Compares the manifest of a folder with the files of the run: every file by its name and its line, except files of
    /// other sets.
    pub fn new(recorded: &Recorded, scope: &Scope<'_>, made: &BTreeMap<&str, Option<&Entry>>) -> Self {
        let mut left = Self { after: made.values().filter_map(|entry| entry.cloned()).collect(), ..Self::default() };
        let gone = sets_without_axes(recorded, made);
        let mut of_others = BTreeSet::new();
        let mut no_more: BTreeMap<&str, &Entry> = BTreeMap::new();
        for entry in &recorded.manifest {
            let is_own = entry.set == recorded.set || gone.contains(entry.set.as_str());
            if made.contains_key(entry.file.as_str()) {
                if !is_own && entry.axis.is_none() {
                    left.after.insert(entry.clone());
                } else if entry.set != recorded.set {
                    *left.taken.entry(entry.set.clone()).or_default() += 1;
                }
            } else if !is_there(&recorded.out.join(&entry.file)) {
                // Files that no longer exist are not listed.
            } else if is_own && scope.covers(entry) {
                no_more.insert(&entry.file, entry);
            } else {
                if !is_own {
                    of_others.insert(entry.file.as_str());
                    *left.others.entry(entry.set.clone()).or_default() += 1;
                }
                left.after.insert(entry.clone());
            }
        }
        left.meanwhile = left.after.clone();
        for (file, entry) in no_more {
            left.judge(&recorded.out, file, entry, of_others.contains(file));
        }
        if scope.is_whole() {
            left.unlisted = recorded.unlisted(&made.keys().copied().collect());
        }
        left
    }

    /// Decides what happens to a file that the set no longer generates.
    fn judge(&mut self, out: &Path, file: &str, entry: &Entry, is_of_others: bool) {
        if is_of_others && entry.axis.is_some() {
            return;
        }
        let path = out.join(file);
        let is_file = fs::symlink_metadata(&path).is_ok_and(|found| found.is_file());
        let content = if is_file { config::load(&path).ok() } else { None };
        match content.map_or(Owner::Other, |content| write::owner(&content)) {
            // A shared file is generated for the axes of all sets: none of them needs it any more.
            Owner::Generated => {
                if entry.axis.is_none() {
                    self.after.retain(|entry| entry.file != file);
                }
                self.meanwhile.insert(entry.clone());
                self.removed.push(file.to_owned());
            }
            owner @ (Owner::Edited | Owner::Other) => {
                self.kept.push((file.to_owned(), owner));
                self.meanwhile.insert(entry.clone());
                self.after.insert(entry.clone());
            }
        }
    }

    /// The messages about files that stay.
    pub fn report(&self, out: &Path) -> Report {
        let place = |file: &String| Place::whole(out.join(file).slashes());
        let kept = self.kept.iter().map(|(file, owner)| {
            Diagnostic::warning(codes::LEFT_OVER, place(file), format!("is no longer generated, but {}", how(*owner)))
                .instead("delete it; to keep it as yours, take its line out of axgen.manifest, and the line `checksum` out of it")
        });
        let unlisted = self.unlisted.iter().map(|file| {
            Diagnostic::warning(codes::UNLISTED, place(file), UNLISTED)
                .instead("generate the set that it belongs to into this folder once, or delete it")
        });
        Report { diagnostics: kept.chain(unlisted).collect() }
    }

    /// The messages for a command that only compares, one line per message, including the files that would be removed.
    pub fn differences(&self, out: &Path) -> Vec<String> {
        let line = |file: &String, found: &str| format!("{}: {found}\n", out.join(file).slashes());
        let removed = self.removed.iter().map(|file| line(file, "is no longer generated"));
        let kept =
            self.kept.iter().map(|(file, owner)| line(file, &format!("is no longer generated, but {}", how(*owner))));
        let unlisted = self.unlisted.iter().map(|file| line(file, UNLISTED));
        removed.chain(kept).chain(unlisted).collect()
    }

    /// The messages about files of other sets, one line per message.
    pub fn of_other_sets(&self, out: &Path) -> String {
        let out = out.slashes();
        let taken =
            self.taken.iter().map(|(set, files)| format!("{out}: took over {} from {set}\n", counted(files, "file")));
        let others =
            self.others.iter().map(|(set, files)| format!("{out}: also has {} of {set}\n", counted(files, "file")));
        taken.chain(others).collect()
    }
}

const UNLISTED: &str = "was generated, but not from this set, and axgen.manifest does not list it";

fn how(owner: Owner) -> &'static str {
    match owner {
        Owner::Edited => "was changed by hand",
        Owner::Generated | Owner::Other => "is not the file that was generated",
    }
}

/// The sets whose files of axes are all generated by this run, or no longer exist: usually the file of the set was renamed.
fn sets_without_axes<'r>(recorded: &'r Recorded, made: &BTreeMap<&str, Option<&Entry>>) -> BTreeSet<&'r str> {
    let mut sets: BTreeSet<&str> = recorded.manifest.iter().map(|entry| entry.set.as_str()).collect();
    for entry in recorded.manifest.iter().filter(|entry| entry.axis.is_some()) {
        if !made.contains_key(entry.file.as_str()) && is_there(&recorded.out.join(&entry.file)) {
            sets.remove(entry.set.as_str());
        }
    }
    sets
}

fn is_there(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}
