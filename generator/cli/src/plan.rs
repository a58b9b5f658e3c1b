//! All files that a run makes, each with its line for the manifest of its folder.

use crate::recorded::Recorded;
use crate::shared;
use compiler::pass::Defect;
use generator::generate::{self, Made};
use generator::manifest::Entry;
use generator::pipeline::Set;
use generator::target::{File, TARGETS, Target, Unit};
use std::path::Path;

/// What is made, and for which axes.
pub struct Plan<'p> {
    set: &'p Set,
    /// empty: all
    axes: &'p [String],
    targets: &'p [Target],
    /// the targets whose shared files are made, each with the axes that these name, and whether the set has files of that target
    shared: Vec<(Target, Vec<Unit<'p>>, bool)>,
}

impl<'p> Plan<'p> {
    /// The plan for a folder. `dropped`: targets that the set had there, and has no more.
    pub fn new(
        (set, axes, targets): (&'p Set, &'p [String], &'p [Target]),
        recorded: &'p Recorded,
        dropped: &[&str],
        out: &Path,
    ) -> Self {
        let own = targets.iter().copied().zip(shared::own(set, axes, targets, out));
        let shared = own.map(|(target, mut units)| {
            units.extend(recorded.units_of_others(set, &target));
            (target, units, true)
        });
        // Other sets' axes stay in the project when those of this set go.
        let of_others = TARGETS.into_iter().filter(|target| dropped.contains(&target.name)).map(|target| {
            let units = recorded.units_of_others(set, &target);
            (target, units, false)
        });
        let of_others: Vec<_> = of_others.filter(|(_, units, _)| !units.is_empty()).collect();
        Self { set, axes, targets, shared: shared.chain(of_others).collect() }
    }

    /// Makes all files. Hands each to `take`, with its line for the manifest, which names `set`; a file without a line is of other sets.
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
        for (target, units, is_own) in &self.shared {
            let of_all = (target.shared)(units);
            let shared = |file: &File| (file.name.clone(), is_own.then(|| entry(file, target.name, None)), take(file));
            files.extend(of_all.iter().map(shared));
        }
        files.extend(generate::pages(self.set, self.axes, of_axis));
        files
    }

    /// What is to be said of axes that shared files do not name.
    pub fn left_out(&self, out: &Path) -> String {
        let own = self.shared.iter().filter(|(.., is_own)| *is_own);
        own.filter_map(|(target, units, _)| shared::left_out(self.set, units, target, out)).collect()
    }
}

/// What was made; a defect is ours, and never anybody's input.
fn made<T>(result: Result<T, Defect>) -> T {
    result.unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"))
}
