//! Stages that are written where an axis has its parameters, proved by reading the result: the axis has exactly these
//! stages, the mode DRYRUN, and all else as before. No file is written here.

use crate::axis::{Axis, Enable, Stage};
use crate::blocks::Designed;
use crate::codes;
use crate::config::{ListOptions, Load, Unreadable};
use crate::diagnostics::{Diagnostic, Place, Report, Slashes};
use crate::diff;
use crate::import_export;
use crate::pipeline::{self, Set};
use std::path::Path;

/// A set, or a list, with other stages.
pub struct Applied {
    /// as the file was when it was read
    pub before: Vec<u8>,
    pub after: Vec<u8>,
    /// what that means for the machine, as `axgen diff` says it
    pub changes: Vec<String>,
}

/// The file of an axis with stages in the place of its own. None: they cannot be written, as the report says.
pub fn stages(
    path: &Path,
    options: &ListOptions,
    axis: &str,
    stages: &[Stage],
    load: Load<'_>,
) -> (Option<Applied>, Report) {
    let before = match load(path) {
        Ok(before) => before,
        Err(unreadable) => return (None, unreadable.diagnostic(path.slashes()).into()),
    };
    let with = |bytes: &[u8], of: &Path| if of == path { Ok(bytes.to_vec()) } else { load(of) };
    let old = |of: &Path| -> Result<Vec<u8>, Unreadable> { with(&before, of) };
    let (after, report) = import_export::with_stages(path, axis, stages, &old);
    let Some(after) = after else { return (None, report) };
    let new = |of: &Path| -> Result<Vec<u8>, Unreadable> { with(&after, of) };
    let (was, _) = pipeline::read_to_look_at(path, options, &old);
    let (is, report) = pipeline::read_with(path, options, &new);
    let (Some(was), Some(is)) = (was, is) else { return (None, report) };
    if !is_proved(&was, &is, axis, stages) {
        let found =
            format!("the stages of the axis {axis} stand in a form that is not edited: other values would change");
        let said = Diagnostic::error(codes::NOT_WRITTEN, Place::whole(path.slashes()), found);
        return (None, said.instead("the stages that were printed, by hand").into());
    }
    let (changes, _) = diff::lines(&was.axes, &is.axes);
    (Some(Applied { before, after, changes }), report)
}

/// Whether the axis has the stages and all else is as it was.
fn is_proved(was: &Set, is: &Set, axis: &str, stages: &[Stage]) -> bool {
    let same = |(was, is): (&Designed, &Designed)| match is.axis.name == axis {
        true => is_changed(&was.axis, &is.axis, stages),
        false => was.axis == is.axis,
    };
    was.axes.len() == is.axes.len() && was.axes.iter().zip(&is.axes).all(same)
}

fn is_changed(was: &Axis, is: &Axis, stages: &[Stage]) -> bool {
    let mut expected = was.clone();
    expected.ipc.enable = Enable::DryRun;
    expected.ipc.stage = std::array::from_fn(|k| stages.get(k).cloned());
    // A measured response is read only where a stage is active.
    expected.drive.clone_from(&is.drive);
    // What the digests are made of names the stages and the mode; the other blocks have neither.
    let rest = |axis: &Axis| {
        let is_kept =
            |line: &&str| !line.contains(".improved_position_control.stage[") && !line.contains("_control.enable ");
        axis.canonical.lines().filter(is_kept).map(str::to_owned).collect::<Vec<_>>()
    };
    let is_rest_same = rest(was) == rest(is);
    (expected.canonical, expected.canonical_of) = (is.canonical.clone(), is.canonical_of.clone());
    is_rest_same && expected == *is
}
