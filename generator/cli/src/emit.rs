//! `axgen generate --emit STAGE`: one stage of the pipeline as text, instead of files.

use crate::exit::Exit;
use crate::output;
use compiler::pass;
use generator::blocks;
use generator::blocks::Designed;

/// The stages, in the order of the pipeline.
fn stages() -> Vec<&'static str> {
    ["parameters", "program"].into_iter().chain(pass::PASSES.map(|(name, _)| name)).collect()
}

/// What the help says of the option.
pub fn help() -> String {
    format!("Print one stage of the pipeline instead: {}", stages().join(", "))
}

/// Prints a stage of every axis.
pub fn run<'a>(axes: impl Iterator<Item = &'a Designed>, stage: &str) -> Result<Exit, Exit> {
    if !stages().contains(&stage) {
        return Err(Exit::no_such("--emit", "stage", stage, &stages()));
    }
    for designed in axes {
        match stage {
            "parameters" => {
                let (name, parameters) = (&designed.axis.name, designed.axis.canonical.trim_end());
                output::line(format!("# axis {name}: every effective parameter\n{parameters}"))?;
            }
            "program" => print(designed, None)?,
            pass => print(designed, Some(pass))?,
        }
    }
    Ok(Exit::Done)
}

/// Prints the programs of an axis after a pass; none: as the specialiser gives them.
fn print(designed: &Designed, last: Option<&str>) -> Result<(), Exit> {
    for kind in blocks::of_axis(&designed.axis) {
        let program = kind.program(designed, last).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"));
        let (name, text) = (&designed.axis.name, compiler::dump::text(&program));
        output::line(format!("# axis {name}: {}\n{}", program.block, text.trim_end()))?;
    }
    Ok(())
}
