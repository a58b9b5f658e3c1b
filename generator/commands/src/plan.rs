//! All files of a run, each with its line for the manifest of its folder. The folder itself is not known here.

use crate::words::made;
use generator::generate::{self, Made};
use generator::manifest::{self, Entry, Manifest};
use generator::pipeline::Set;
use generator::target::{File, Target, Unit};
use std::collections::BTreeSet;

/// The files to generate, and their axes.
pub struct Plan<'p> {
    pub set: &'p Set,
    /// empty for all
    pub axes: &'p [String],
    pub targets: &'p [Target],
    /// the targets, and the other targets of the set's files in the folder
    pub there: Vec<Target>,
    /// the targets whose shared files are generated
    pub shared: Vec<Shared<'p>>,
}

/// The axes in the shared files of a target.
pub struct Shared<'p> {
    pub target: Target,
    /// the axes of the set; empty if the set no longer has files of the target
    pub own: Vec<Unit<'p>>,
    /// axes of other sets
    pub others: Vec<Unit<'p>>,
}

impl Shared<'_> {
    /// The axes of the set and of other sets.
    #[must_use]
    pub fn units(&self) -> Vec<Unit<'_>> {
        self.own.iter().chain(&self.others).cloned().collect()
    }

    /// The names of the files that the set itself needs.
    fn own_names(&self) -> BTreeSet<String> {
        let files = if self.own.is_empty() { Vec::new() } else { (self.target.shared)(&self.own) };
        files.into_iter().map(|file| file.name).collect()
    }
}

impl<'p> Plan<'p> {
    /// The plan for an empty folder.
    #[must_use]
    pub fn whole(set: &'p Set, targets: &'p [Target]) -> Self {
        let shared = |target: &Target| Shared { target: *target, own: generate::units(set), others: Vec::new() };
        let shared = targets.iter().map(shared).collect();
        // In the order of the registry, as on a page.
        let there = generator::target::of_names(|name| targets.iter().any(|target| target.name == name));
        Self { set, axes: &[], targets, there, shared }
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

    /// All files and their manifest, which names `set`: the content of a folder that was empty.
    #[must_use]
    pub fn folder(&self, set: &str) -> Vec<File> {
        let made = self.files(set, File::clone);
        let manifest: Manifest = made.iter().filter_map(|(_, entry, _)| entry.clone()).collect();
        let manifest = File { name: manifest::NAME.to_owned(), text: manifest::text(&manifest) };
        made.into_iter().map(|(.., file)| file).chain([manifest]).collect()
    }
}
