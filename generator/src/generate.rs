//! The whole way from a set to its files. Each step is one call.

use crate::axis::Axis;
use crate::block;
use crate::config::Set;
use crate::pass::Defect;
use crate::target::{File, Target};
use rayon::prelude::*;

/// The files of all axes for some targets, in the order of the axes. Axes do not know each other: they are made side by side.
///
/// # Errors
/// A defect of a block or of a pass.
pub fn files(set: &Set, targets: &[Target]) -> Result<Vec<File>, Defect> {
    let per_axis: Result<Vec<_>, Defect> = set.axes.par_iter().map(|axis| axis_files(axis, targets)).collect();
    Ok(per_axis?.into_iter().flatten().collect())
}

/// Design, specialise and the passes once; then each target prints.
fn axis_files(axis: &Axis, targets: &[Target]) -> Result<Vec<File>, Defect> {
    let blocks = block::blocks(axis)?;
    Ok(targets.iter().flat_map(|target| (target.files)(axis, &blocks)).collect())
}
