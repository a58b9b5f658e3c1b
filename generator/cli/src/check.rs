//! `axgen check`: reads and checks the set, and reports the effect of its blocks; with `--verbose` also their proven
//! properties, in figures.

use crate::arguments::SetArguments;
use crate::exit::Exit;
use crate::input;
use crate::messages::Format;
use crate::output;
use commands::check;

/// Runs the command.
pub fn run(arguments: &SetArguments, format: Format, verbose: bool) -> Result<Exit, Exit> {
    let (set, warnings) = input::read(arguments, format)?;
    output::print(check::check(&set, warnings, verbose).text())?;
    Ok(Exit::Done)
}
