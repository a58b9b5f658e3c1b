//! The whole way from a set to its files. Each step is one call.

use crate::axis::Axis;
use crate::block;
use crate::config::Set;
use crate::pass::Defect;
use crate::target::{File, Target};
use rayon::prelude::*;

/// Makes the files of all axes for some targets and hands each to `take`; gives its answers, in the order of the axes.
///
/// Axes do not know each other: they are made side by side, and no file is kept longer than `take` needs it.
///
/// # Errors
/// A defect of a block or of a pass.
pub fn files<T: Send>(set: &Set, targets: &[Target], take: impl Fn(File) -> T + Sync) -> Result<Vec<T>, Defect> {
    let taken: Result<Vec<Vec<T>>, Defect> =
        set.axes.par_iter().map(|axis| Ok(axis_files(axis, targets)?.into_iter().map(&take).collect())).collect();
    Ok(taken?.into_iter().flatten().collect())
}

/// Design, specialise and the passes once; then each target prints.
fn axis_files(axis: &Axis, targets: &[Target]) -> Result<Vec<File>, Defect> {
    let blocks = block::blocks(axis)?;
    Ok(targets.iter().flat_map(|target| (target.files)(axis, &blocks)).collect())
}
