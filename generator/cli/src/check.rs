//! `axgen check`: reads and checks the set, and says what its blocks would do.

use crate::arguments::SetArguments;
use crate::exit::Exit;
use crate::input::{self, counted};
use crate::summary;
use generator::block;

/// Runs the command.
#[expect(clippy::print_stdout, reason = "what the command has found")]
pub fn run(arguments: &SetArguments) -> Result<Exit, Exit> {
    let (set, warnings) = input::read(arguments)?;
    for axis in &set.axes {
        print!("{}", summary::of(axis));
        for block in block::blocks(axis).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}")) {
            block.certificate.iter().for_each(|line| println!("  {line}"));
        }
    }
    println!("{}, {} of other functions passed over", counted(warnings, "warning"), counted(set.foreign, "parameter"));
    Ok(Exit::Done)
}
