//! From a set to its files. Each step is one call.

use crate::blocks::{self, Block, Designed};
use crate::target::{BlockIdentity, File, Target, Unit};
use crate::{axis::Axis, commissioning, digest::digest, pipeline::Set};
use compiler::pass::Defect;
use rayon::prelude::*;
use std::collections::btree_map::{BTreeMap, Entry};

/// The target of a file in the manifest of a folder if no target prints it.
pub const PAGE: &str = "page";

/// A generated file with its target and axis.
#[derive(Clone, Debug)]
pub struct Made<'s> {
    /// the name of its target, or [`PAGE`]
    pub target: &'static str,
    /// the axis whose file it is
    pub axis: &'s str,
    pub file: File,
}

/// Generates the files of some axes (of all, if none is named) for some targets. Passes each to `take` and returns its
/// results, in the order of the axes.
///
/// Axes are independent: they are generated in parallel, and a file is dropped after `take`.
///
/// # Errors
/// A defect of a block or of a pass.
pub fn files<T: Send>(
    set: &Set,
    axes: &[String],
    targets: &[Target],
    take: impl Fn(Made<'_>) -> T + Sync,
) -> Result<Vec<T>, Defect> {
    let taken = chosen(set, axes).map(|designed| {
        let made = |(target, file)| take(Made { target, axis: &designed.axis.name, file });
        Ok(files_by_target(designed, targets)?.into_iter().map(made).collect())
    });
    let taken: Vec<Vec<T>> = taken.collect::<Result<_, Defect>>()?;
    Ok(taken.into_iter().flatten().collect())
}

/// Generates the commissioning pages of some axes (of all, if none is named). A page belongs to an axis, not to one of its
/// blocks; it has the names of all `targets`. Passes each to `take` and returns its results, in the order of the axes.
pub fn pages<T: Send>(set: &Set, axes: &[String], targets: &[Target], take: impl Fn(Made<'_>) -> T + Sync) -> Vec<T> {
    let page = |designed: &'_ Designed| {
        let file = commissioning::file(designed, parameters_digest(&designed.axis, blocks::IPC), targets)?;
        Some(take(Made { target: PAGE, axis: &designed.axis.name, file }))
    };
    chosen(set, axes).filter_map(page).collect()
}

/// The axes of these names, or all, if none is named.
fn chosen<'s>(set: &'s Set, axes: &'s [String]) -> impl ParallelIterator<Item = &'s Designed> {
    set.axes.par_iter().filter(|of| axes.is_empty() || axes.contains(&of.axis.name))
}

/// The digest of the effective parameters of a block of an axis.
fn parameters_digest(axis: &Axis, block: &str) -> String {
    let terms = blocks::named(block).map_or_else(String::new, |kind| kind.terms(axis));
    digest((axis.canonical_of(block).to_owned() + &terms).as_bytes())
}

/// The facts about the axes that a shared file may contain.
pub fn units<'s>(set: &'s Set) -> Vec<Unit<'s>> {
    let unit = |of: &'s Designed| Unit {
        axis: &of.axis.name,
        reals: blocks::of_axis(&of.axis).map(|kind| kind.computes_in(of)).collect(),
        blocks: blocks::names(&of.axis),
        takes_sets: of.axis.ipc.takes_sets(),
    };
    set.axes.iter().map(unit).collect()
}

/// What the head of a file says of an axis and of one of its blocks.
pub fn identity(axis: &Axis, block: &Block) -> BlockIdentity {
    let name = block.program.block;
    BlockIdentity {
        name: axis.name.clone(),
        real: block.program.real,
        short_names: axis.short_names,
        cycle_time_ns: axis.cycle_time_ns,
        is_rotary: axis.control.is_rotary,
        parameters_digest: parameters_digest(axis, name),
        structure_digest: digest(format!("cycle_time_ns {}\n{}", axis.cycle_time_ns, block.structure).as_bytes()),
    }
}

/// The files of an axis.
///
/// # Errors
/// A defect of a block or of a pass.
pub fn axis_files(designed: &Designed, targets: &[Target]) -> Result<Vec<File>, Defect> {
    Ok(files_by_target(designed, targets)?.into_iter().map(|(_, file)| file).collect())
}

/// The files of an axis with the names of their targets. Design, specialisation and passes run once for each block, and
/// legalisation once for targets with the same passes. Then each target prints, requested runners and descriptions too.
fn files_by_target(designed: &Designed, targets: &[Target]) -> Result<Vec<(&'static str, File)>, Defect> {
    let kinds = blocks::of_axis(&designed.axis);
    let blocks = kinds.map(|kind| Ok((kind, kind.block(designed)?))).collect::<Result<Vec<_>, Defect>>()?;
    let identities: Vec<BlockIdentity> = blocks.iter().map(|(_, block)| identity(&designed.axis, block)).collect();
    let (mut files, mut in_form) = (Vec::new(), BTreeMap::new());
    for target in targets {
        for (identity, (kind, block)) in identities.iter().zip(&blocks) {
            let in_form = match in_form.entry((block.program.block, target.passes_of(block))) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(unknown) => unknown.insert(target.block(block)?),
            };
            let runner = target.runner(identity, in_form, |samples| kind.runner(designed, block, samples));
            let of_block = (target.files)(identity, in_form).into_iter().chain(runner);
            let of_block = of_block.chain(target.description(identity, in_form));
            files.extend(of_block.map(|file| (target.name, file)));
        }
    }
    Ok(files)
}
