//! `axgen diff`: the effect of a change between two sets on the machine.

use crate::exit::Exit;
use crate::input::said;
use crate::messages::Format;
use crate::output;
use generator::config::{self, ListOptions};
use generator::diff;
use generator::pipeline::{self, Set};
use std::path::Path;

/// Runs the command. `options` are for axis lists; two lists are versions of one axis, even if their file names differ.
pub fn run(old: &Path, new: &Path, options: &ListOptions, format: Format) -> Result<Exit, Exit> {
    let (mut before, after) = both(old, new, options, format)?;
    if let ([before], [after], false, false) =
        (before.axes.as_mut_slice(), after.axes.as_slice(), is_set(old), is_set(new))
    {
        before.axis.name.clone_from(&after.axis.name);
    }
    let (lines, differ) = diff::lines(&before.axes, &after.axes);
    for line in lines {
        output::line(line)?;
    }
    Ok(if differ { Exit::Different } else { Exit::Done })
}

/// Reads two versions of axes. `options` are for axis lists.
pub fn both(old: &Path, new: &Path, options: &ListOptions, format: Format) -> Result<(Set, Set), Exit> {
    let some_list = !is_set(old) || !is_set(new);
    let load = |path: &Path, are_warnings_said| {
        let none = ListOptions::default();
        read(path, if is_set(path) && some_list { &none } else { options }, format, are_warnings_said)
    };
    // Both are read, so that the errors of both are reported. Warnings are reported only for the new version.
    match (load(old, false), load(new, true)) {
        (Ok(before), Ok(after)) => Ok((before, after)),
        (Err(exit), _) | (_, Err(exit)) => Err(exit),
    }
}

fn read(path: &Path, options: &ListOptions, format: Format, are_warnings_said: bool) -> Result<Set, Exit> {
    // An unstable version can be compared, too: usually with one that is stable.
    let (set, report) = pipeline::read_to_look_at(path, options, &config::load);
    match set {
        Some(set) if !are_warnings_said => Ok(set),
        set => said(set, &report, format),
    }
}

fn is_set(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}
