//! All files of a run, each with its line for the manifest of its folder.

use crate::recorded::Recorded;
use crate::shared;
use compiler::pass::Defect;
use generator::generate::{self, Made};
use generator::manifest::Entry;
use generator::pipeline::Set;
use generator::target::{self, File, TARGETS, Target, Unit};
use std::collections::BTreeSet;
use std::path::Path;

/// The files to generate, and their axes.
pub struct Plan<'p> {
    set: &'p Set,
    /// empty for all
    axes: &'p [String],
    targets: &'p [Target],
    /// the targets, and the other targets of the set's files in the folder
    there: Vec<Target>,
    /// the targets whose shared files are generated
    shared: Vec<Shared<'p>>,
}

/// The axes in the shared files of a target.
struct Shared<'p> {
    target: Target,
    /// the axes of the set; empty if the set no longer has files of the target
    own: Vec<Unit<'p>>,
    /// axes of other sets
    others: Vec<Unit<'p>>,
}

impl Shared<'_> {
    /// The axes of the set and of other sets.
    fn units(&self) -> Vec<Unit<'_>> {
        self.own.iter().chain(&self.others).cloned().collect()
    }

    /// The names of the files that the set itself needs.
    fn own_names(&self) -> BTreeSet<String> {
        let files = if self.own.is_empty() { Vec::new() } else { (self.target.shared)(&self.own) };
        files.into_iter().map(|file| file.name).collect()
    }
}

impl<'p> Plan<'p> {
    /// The plan for a folder. `dropped`: targets that the set had there and no longer has.
    pub fn new(
        (set, axes, targets): (&'p Set, &'p [String], &'p [Target]),
        recorded: &'p Recorded,
        dropped: &[&str],
        out: &Path,
    ) -> Self {
        let known = recorded.targets();
        let there = target::of_names(|name| {
            targets.iter().any(|target| target.name == name) || known.contains(name) && !dropped.contains(&name)
        });
        let others = |target: &Target| recorded.units_of_others(set, target);
        let own = targets.iter().copied().zip(shared::of_set(set, axes, targets, out));
        let own = own.map(|(target, own)| Shared { target, own, others: others(&target) });
        // Axes of other sets stay in the project when those of this set are removed.
        let dropped = TARGETS.into_iter().filter(|target| dropped.contains(&target.name));
        let dropped = dropped.map(|target| Shared { target, own: Vec::new(), others: others(&target) });
        let dropped = dropped.filter(|shared| !shared.others.is_empty());
        let shared = own.chain(dropped).collect();
        Self { set, axes, targets, there, shared }
    }

    /// Generates all files. Passes each to `take`, with its line for the manifest, which names `set`. A file without a line
    /// is needed only by other sets.
    pub fn files<T: Send>(&self, set: &str, take: impl Fn(&File) -> T + Sync) -> Vec<(String, Option<Entry>, T)> {
        let entry = |file: &File, target: &str, axis: Option<&str>| Entry {
            file: file.name.clone(),
            target: target.to_owned(),
            axis: axis.map(str::to_owned),
            set: set.to_owned(),
        };
        let of_axis = |Made { target, axis, file }: Made<'_>| {
            let entry = entry(&file, target, Some(axis));
            (file.name.clone(), Some(entry), take(&file))
        };
        let mut files = made(generate::files(self.set, self.axes, self.targets, of_axis));
        for shared in &self.shared {
            let own = shared.own_names();
            files.extend((shared.target.shared)(&shared.units()).iter().map(|file| {
                let entry = own.contains(&file.name).then(|| entry(file, shared.target.name, None));
                (file.name.clone(), entry, take(file))
            }));
        }
        files.extend(generate::pages(self.set, self.axes, &self.there, of_axis));
        files
    }

    /// The messages about axes that shared files do not name.
    pub fn left_out(&self, out: &Path) -> String {
        let own = self.shared.iter().filter(|shared| !shared.own.is_empty());
        own.filter_map(|shared| shared::left_out(self.set, &shared.units(), &shared.target, out)).collect()
    }
}

/// The result; a defect is an error of axgen, not of its input.
fn made<T>(result: Result<T, Defect>) -> T {
    result.unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"))
}
