//! The whole way from a set to its files. Each step is one call.

use crate::blocks::{self, Block, Designed, Part};
use crate::target::{File, Header, Target, Unit};
use crate::{axis::Axis, commissioning, digest::digest, pipeline::Set};
use compiler::pass::Defect;
use rayon::prelude::*;
use std::collections::btree_map::{BTreeMap, Entry};

/// Makes the files of some axes (all, if none is named) for some targets, and what all axes of the set share there. Hands
/// each file to `take`; gives its answers, in the order of the axes, the shared files last.
///
/// Axes do not know each other: they are made side by side, and no file is kept longer than `take` needs it.
///
/// # Errors
/// A defect of a block or of a pass.
pub fn files<T: Send>(
    set: &Set,
    axes: &[String],
    targets: &[Target],
    take: impl Fn(File) -> T + Sync,
) -> Result<Vec<T>, Defect> {
    let taken = chosen(set, axes).map(|designed| Ok(axis_files(designed, targets)?.into_iter().map(&take).collect()));
    let taken: Vec<Vec<T>> = taken.collect::<Result<_, Defect>>()?;
    let units = units(set);
    let shared = targets.iter().flat_map(|target| (target.shared)(&units)).map(&take);
    Ok(taken.into_iter().flatten().chain(shared).collect())
}

/// Makes the commissioning pages of some axes (all, if none is named). A page belongs to an axis, not to one of its blocks and not to a
/// target. Hands each to `take`; gives its answers, in the order of the axes.
pub fn pages<T: Send>(set: &Set, axes: &[String], take: impl Fn(File) -> T + Sync) -> Vec<T> {
    let page = |designed: &Designed| commissioning::file(designed, parameters_digest(&designed.axis, blocks::IPC));
    chosen(set, axes).filter_map(page).map(&take).collect()
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

/// What a shared file may know of the axes.
pub fn units<'s>(set: &'s Set) -> Vec<Unit<'s>> {
    let unit = |of: &'s Designed| Unit {
        axis: &of.axis.name,
        real: of.axis.real,
        blocks: blocks::names(&of.axis),
        takes_sets: of.axis.ipc.takes_sets().then_some(blocks::IPC),
    };
    set.axes.iter().map(unit).collect()
}

/// What the head of a file says of an axis and of one of its blocks.
pub fn header(axis: &Axis, block: &Block) -> Header {
    let name = block.program.block;
    let kind = blocks::named(name);
    Header {
        name: axis.name.clone(),
        real: axis.real,
        short_name: kind.filter(|_| axis.short_names).map(Part::short_name),
        cycle_time_ns: axis.cycle_time_ns,
        is_rotary: axis.control.is_rotary,
        parameters_digest: parameters_digest(axis, name),
        structure_digest: digest(format!("cycle_time_ns {}\n{}", axis.cycle_time_ns, block.structure).as_bytes()),
    }
}

/// The files of an axis: design, specialise and the passes once for each block, and legalise once for the targets that need the same; then
/// each target prints, and the runners that are asked for are recorded.
///
/// # Errors
/// A defect of a block or of a pass.
pub fn axis_files(designed: &Designed, targets: &[Target]) -> Result<Vec<File>, Defect> {
    let kinds = blocks::of_axis(&designed.axis);
    let blocks = kinds.map(|kind| Ok((kind, kind.block(designed)?))).collect::<Result<Vec<_>, Defect>>()?;
    let headers: Vec<Header> = blocks.iter().map(|(_, block)| header(&designed.axis, block)).collect();
    let (mut files, mut legal) = (Vec::new(), BTreeMap::new());
    for target in targets {
        for (header, (kind, block)) in headers.iter().zip(&blocks) {
            let legal = match legal.entry((block.program.block, target.passes_of(block))) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(unknown) => unknown.insert(target.legal(block)?),
            };
            files.extend((target.files)(header, legal));
            files.extend(target.runner(header, legal, |samples| kind.runner(designed, block, samples)));
        }
    }
    Ok(files)
}
