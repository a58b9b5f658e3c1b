//! `axgen check`: reads and checks the set, and reports the effect of its blocks; with `--verbose` also their proven
//! properties, in figures.

use crate::arguments::SetArguments;
use crate::exit::Exit;
use crate::input::{self, counted};
use crate::messages::Format;
use crate::output;
use generator::{blocks, summary};

/// Runs the command.
pub fn run(arguments: &SetArguments, format: Format, verbose: bool) -> Result<Exit, Exit> {
    let (set, warnings) = input::read(arguments, format)?;
    for designed in &set.axes {
        output::print(summary::details(designed))?;
        if !verbose {
            continue;
        }
        for block in blocks::blocks(designed).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}")) {
            output::line(format!("  {}, whatever its state and its inputs hold:", block.program.block))?;
            block.shown.lines(&block.program).iter().try_for_each(|line| output::line(format!("    {line}")))?;
            block.certificate.lines.iter().try_for_each(|line| output::line(format!("  {line}")))?;
        }
    }
    let (warnings, foreign) = (counted(warnings, "warning"), counted(set.foreign, "parameter"));
    output::line(format!("{warnings}, {foreign} of other functions passed over"))?;
    Ok(Exit::Done)
}
