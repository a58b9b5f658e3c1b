//! Stages that are written where an axis has its parameters, proved by reading the result: the axis has exactly these
//! stages, the mode DRYRUN, and all else as before. No file is written here.

use crate::axis::{Enable, Stage};
use crate::blocks::Designed;
use crate::codes;
use crate::config::given::{self, Given, GivenAxis};
use crate::config::values::{Key, Values};
use crate::config::{ListOptions, Load, Unreadable};
use crate::diagnostics::{Diagnostic, Place, Report, Slashes};
use crate::diff;
use crate::import_export;
use crate::parameters::{Name, Value};
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

/// The file of an axis with stages instead of its own. None: they cannot be written, as the report says.
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
    let given = |load| given::read(path, options, load);
    let is_kept = match (given(&old), given(&new)) {
        (Ok(was), Ok(new)) => is_proved(&was, &new, axis, stages, &is),
        (Err(_), _) | (_, Err(_)) => false,
    };
    if !is_kept {
        let found =
            format!("the stages of the axis {axis} stand in a form that is not edited: other values would change");
        let said = Diagnostic::error(codes::NOT_WRITTEN, Place::whole(path.slashes()), found);
        return (None, said.instead("the stages that were printed, by hand").into());
    }
    let (changes, _) = diff::lines(&was.axes, &is.axes);
    (Some(Applied { before, after, changes }), report)
}

/// Whether the axis has the stages and the mode DRYRUN, and every other value of the file is as it was. Values are compared as
/// they were read: what they mean can depend on whether a stage is active.
fn is_proved(was: &Given, is: &Given, axis: &str, stages: &[Stage], set: &Set) -> bool {
    let of_axis = |designed: &&Designed| designed.axis.name == axis;
    let ipc = set.axes.iter().find(of_axis).map(|designed| &designed.axis.ipc);
    let is_written = ipc.is_some_and(|ipc| ipc.enable == Enable::DryRun && ipc.stage.iter().flatten().eq(stages));
    let same = |(was, is): (&GivenAxis, &GivenAxis)| {
        was.name == is.name && was.foreign.count == is.foreign.count && kept(was, axis) == kept(is, axis)
    };
    is_written && was.axes.len() == is.axes.len() && was.axes.iter().zip(&is.axes).all(same)
}

/// The values of an axis, without those that are written to it.
fn kept<'g>(of: &'g GivenAxis, axis: &str) -> Vec<(Key, &'g Option<Value>)> {
    let is_kept = |(name, _): Key| of.name != axis || name != Name::Enable && !given::is_of_stage(name);
    let values = of.values.iter().flat_map(Values::iter);
    values.filter(|(key, _)| is_kept(*key)).map(|(key, setting)| (key, &setting.value)).collect()
}
