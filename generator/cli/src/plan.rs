//! The files of a run, by the output folder: what is there for other targets and other sets.

use crate::recorded::Recorded;
use crate::shared;
use commands::plan::{Plan, Shared};
use generator::pipeline::Set;
use generator::target::{self, TARGETS, Target};
use std::path::Path;

/// The plan for a folder. `dropped`: targets that the set had there and no longer has.
pub fn for_folder<'p>(
    (set, axes, targets): (&'p Set, &'p [String], &'p [Target]),
    recorded: &'p Recorded,
    dropped: &[&str],
    out: &Path,
) -> Plan<'p> {
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
    Plan { set, axes, targets, there, shared: own.chain(dropped).collect() }
}

/// The messages about axes that shared files do not name.
pub fn left_out(plan: &Plan<'_>, out: &Path) -> String {
    let own = plan.shared.iter().filter(|shared| !shared.own.is_empty());
    own.filter_map(|shared| shared::left_out(plan.set, &shared.units(), &shared.target, out)).collect()
}
