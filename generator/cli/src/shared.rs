//! `generate --axis`: what the files that all axes of a set share name, where only some of the axes are written.
//!
//! They name the axes that are written, and those whose files are in the folder already: what TwinCAT's project file names is
//! there, whichever axes were written one by one, and writing one anew takes none out: docs/decisions/0017-single-axes.md.

use generator::axis::Axis;
use generator::block;
use generator::config::Set;
use generator::target::{Target, Unit};
use std::path::Path;
use std::slice;

/// Axes that are named one by one; of more, only their number is said.
const NAMED_AXES: usize = 10;

/// The set as the shared files of a target name it.
pub fn named(set: &Set, axes: &[String], target: &Target, out: &Path) -> Set {
    let has_shared = units(set).first().is_some_and(|unit| !(target.shared)(slice::from_ref(unit)).is_empty());
    let is_named = |axis: &&Axis| axes.contains(&axis.name) || (has_shared && is_there(axis, target, out));
    Set {
        targets: set.targets.clone(),
        axes: set.axes.iter().filter(is_named).cloned().collect(),
        foreign: set.foreign,
    }
}

/// What is to be said where the shared files of a target are not those of the whole set.
pub fn left_out(set: &Set, axes: &[String], target: &Target, out: &Path) -> Option<String> {
    if axes.is_empty() {
        return None;
    }
    let named = named(set, axes, target, out);
    if (target.shared)(&units(&named)) == (target.shared)(&units(set)) {
        return None;
    }
    let names: Vec<&str> =
        set.axes.iter().filter(|axis| !named.axes.contains(axis)).map(|axis| axis.name.as_str()).collect();
    let names = if names.len() > NAMED_AXES { format!("{} axes", names.len()) } else { names.join(", ") };
    let (target, out) = (target.name, out.display());
    Some(format!("{target}: the shared files leave out {names}: their files are not in {out}\n"))
}

/// Whether the folder has all files of an axis, as they are now or were once.
fn is_there(axis: &Axis, target: &Target, out: &Path) -> bool {
    let blocks = block::blocks(axis).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"));
    let files = (target.files)(axis, &blocks);
    !files.is_empty() && files.iter().all(|file| out.join(&file.name).is_file())
}

fn units<'a>(set: &'a Set) -> Vec<Unit<'a>> {
    let unit = |axis: &'a Axis| Unit { axis: &axis.name, real: axis.real, blocks: block::names(axis) };
    set.axes.iter().map(unit).collect()
}
