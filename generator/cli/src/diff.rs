//! `axgen diff`: the effect of a change between two sets on the machine.

use crate::exit::Exit;
use crate::input::said;
use crate::messages::Format;
use crate::output;
use commands::diff::{self, Changes, Version};
use generator::config::{self, ListOptions};
use generator::pipeline::Set;
use std::path::Path;

/// Runs the command. `options` are for axis lists.
pub fn run(old: &Path, new: &Path, options: &ListOptions, format: Format) -> Result<Exit, Exit> {
    let (before, after) = both(diff::read([old, new], options, &config::load), format)?;
    let Changes { lines, differ } = diff::diff([old, new], before, &after);
    lines.into_iter().try_for_each(output::line)?;
    Ok(if differ { Exit::Different } else { Exit::Done })
}

/// Two versions of axes that were read. The errors of both are reported, and the warnings of the new one.
pub fn both([(before, of_old), (after, of_new)]: [Version; 2], format: Format) -> Result<(Set, Set), Exit> {
    let before = before.map_or_else(|| said(None, &of_old, format), Ok);
    let after = said(after, &of_new, format);
    Ok((before?, after?))
}
