//! `axgen check`: reads and checks the set, and says what its blocks would do.

use crate::SetArguments;
use crate::exit::Exit;
use crate::input::{self, counted};
use crate::summary;

/// Runs the command.
#[expect(clippy::print_stdout, reason = "what the command has found")]
pub fn run(arguments: &SetArguments) -> Result<Exit, Exit> {
    let (set, warnings) = input::read(arguments)?;
    for axis in &set.axes {
        print!("{}", summary::of(axis));
    }
    println!("{}, {} of other functions passed over", counted(warnings, "warning"), counted(set.foreign, "parameter"));
    Ok(Exit::Done)
}
