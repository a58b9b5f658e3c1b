//! The source of a golden case's inputs: a stimulus, or the recorded inputs of a scenario, which are generated again only on
//! request. Not the answers of the block.

use crate::csv;
use crate::mistake::Mistake;
use crate::samples::{Samples, Shape};
use crate::scenario;
use crate::stimulus::Stimulus;
use generator::blocks::{Block, Designed};
use generator::config;
use generator::diagnostics::Slashes;
use generator::digest::digest;
use std::path::{Path, PathBuf};

/// The file of the inputs.
pub(crate) const INPUTS: &str = "inputs.csv";
/// The file of the digests.
pub(crate) const DIGEST: &str = "digest";

/// The source of inputs.
#[derive(Clone, Debug)]
pub enum Source {
    /// computed each time
    Stimulus(Stimulus),
    /// generated once by this NC program
    Scenario(PathBuf),
}

/// The inputs that a program generates now, if they are to be recorded: if there are none yet, or with `again`.
///
/// # Errors
/// The program cannot be run, or differs from that of the recorded inputs.
pub(crate) fn made(
    program: &Path,
    folder: &Path,
    designed: &Designed,
    block: &Block,
    again: bool,
) -> Result<Option<Samples>, String> {
    if folder.join(INPUTS).exists() && !again {
        return same_program(program, folder).map(|()| None);
    }
    let scenario =
        scenario::run(&text(program)?, designed, block, &scenario::Options::default()).map_err(|mistakes| {
            let lines = mistakes.iter().map(|mistake| format!("{}:{mistake}", program.slashes()));
            lines.collect::<Vec<_>>().join("\n")
        })?;
    Ok(Some(scenario.inputs))
}

/// Checks that the recorded inputs are those of this program.
///
/// # Errors
/// They are not, in words.
pub(crate) fn same_program(program: &Path, folder: &Path) -> Result<(), String> {
    let line = program_line(program)?;
    match config::load(&folder.join(DIGEST)) {
        Ok(found) if String::from_utf8_lossy(&found).ends_with(&line) => Ok(()),
        _ => Err(format!(
            "{}: is not the program whose inputs are recorded in {INPUTS}; --again records them again",
            program.slashes()
        )),
    }
}

/// The recorded inputs.
///
/// # Errors
/// They do not exist, or are not samples of the block.
pub(crate) fn recorded(folder: &Path, shape: &Shape) -> Result<Samples, String> {
    let path = folder.join(INPUTS);
    csv::read(&text(&path)?, shape).map_err(|mistakes| {
        let line = |Mistake { line, column, found, allowed, .. }: &Mistake| {
            format!("{}:{line}:{column}: {found}; allowed: {allowed}", path.slashes())
        };
        mistakes.iter().map(line).collect::<Vec<_>>().join("\n")
    })
}

/// The line about the program in `digest`.
pub(crate) fn program_line(program: &Path) -> Result<String, String> {
    Ok(format!("program {}\n", digest(text(program)?.as_bytes())))
}

/// The text of a file.
pub(crate) fn text(path: &Path) -> Result<String, String> {
    let bytes = config::load(path).map_err(|unreadable| format!("{}: {}", path.slashes(), unreadable.said().1))?;
    String::from_utf8(bytes).map_err(|error| format!("{}: {error}", path.slashes()))
}
