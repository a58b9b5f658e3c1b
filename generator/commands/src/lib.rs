//! The commands of axgen: a request in; texts, data, messages and files out. The command line and a page are shells over it:
//! they read the files, print, write, and measure time. Nothing here does.
//!
//! ```text
//! refused   refusals of a request       words     words of several commands      json   data as text
//! files     the files of a request      messages  messages with their lines
//! check     the axes of a set, and their verdicts
//! plan      all files of a set          generate  the targets, and the last line
//! emit      a stage of the pipeline as text
//! params    the table of parameters           explain   codes, errors and words
//! verify    the runs of every block in every engine, row by row
//! compared  a recording of a controller against an engine
//! scenario  an NC program on an axis
//! analyze   the loop of an axis: margins, and its curves as numbers
//! samples   mistakes of recordings
//! measure   recordings, and what was measured  tune      proposed stages
//! diff      two versions of a set
//! stages    other numbers of a stage, in the file of the user
//! trace     parameter -> coefficient -> line  report    all of an axis as a page to print
//! ```
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler
#![forbid(unsafe_code)]

pub mod analyze;
pub mod check;
pub mod compared;
pub mod diff;
pub mod emit;
pub mod explain;
pub mod files;
pub mod generate;
pub mod json;
pub mod measure;
pub mod messages;
pub mod params;
pub mod plan;
pub mod refused;
pub mod report;
pub mod samples;
pub mod scenario;
pub mod stages;
pub mod trace;
pub mod tune;
pub mod verify;
pub mod words;

use generator::blocks::{self, Block, Designed};
use generator::codes;
use generator::diagnostics::{Diagnostic, Place, Report};
use generator::pipeline::Set;
use golden::case::named_block;
use words::made;

/// The axis of that name, or the only one.
///
/// # Errors
/// There is no such axis, or there are several.
pub fn axis<'s>(set: &'s Set, name: Option<&str>) -> Result<&'s Designed, Report> {
    const OPTION: &str = "--axis";
    let names: Vec<&str> = set.axes.iter().map(|of| of.axis.name.as_str()).collect();
    match (name, set.axes.as_slice()) {
        (None, [axis]) => Ok(axis),
        (None, _) => {
            let which = Diagnostic::error(codes::USAGE, Place::whole(OPTION), "the set has several axes: which one?");
            Err(which.allowed(names.join(", ")).into())
        }
        (Some(name), axes) => {
            axes.iter().find(|of| of.axis.name == name).ok_or_else(|| refused::no_such(OPTION, "axis", name, &names))
        }
    }
}

/// The block of that name.
///
/// # Errors
/// The axis has no such block.
pub fn block(designed: &Designed, name: &str) -> Result<Block, Report> {
    let names = blocks::names(&designed.axis);
    if !names.contains(&name) {
        return Err(refused::no_such("--block", "block", name, &names));
    }
    Ok(made(named_block(designed, name)))
}
