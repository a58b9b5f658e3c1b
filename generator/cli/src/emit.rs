//! `axgen generate --emit STAGE`: one stage of the pipeline as text, instead of files.

use crate::exit::Exit;
use crate::output;
use compiler::pass::{self, Defect};
use compiler::program::Program;
use generator::blocks::{self, Designed};
use generator::target::{self, TARGETS};
use std::borrow::Cow;

/// The stages, in the order of the pipeline; at the end the programs for targets with their own passes.
fn stages() -> Vec<&'static str> {
    let targets = TARGETS.iter().filter(|target| !target.passes.is_empty()).map(|target| target.name);
    ["parameters", "program"].into_iter().chain(pass::PASSES.map(|(name, _)| name)).chain(targets).collect()
}

/// The help text of the option.
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

/// Prints the programs of an axis after a pass, or for a target; with `None`, the output of the specialiser.
fn print(designed: &Designed, last: Option<&str>) -> Result<(), Exit> {
    let programs = match last.and_then(target::named) {
        Some(target) => {
            let blocks = blocks::blocks(designed).unwrap_or_else(|defect| broken(&defect));
            blocks.iter().map(|block| target.program(block).map(Cow::into_owned)).collect()
        }
        None => blocks::of_axis(&designed.axis).map(|kind| kind.program(designed, last)).collect(),
    };
    let programs: Vec<Program> = Result::unwrap_or_else(programs, |defect| broken(&defect));
    for program in programs {
        let (name, text) = (&designed.axis.name, program.to_string());
        output::line(format!("# axis {name}: {}\n{}", program.block, text.trim_end()))?;
    }
    Ok(())
}

fn broken(defect: &Defect) -> ! {
    panic!("a defect of axgen: {defect}")
}
