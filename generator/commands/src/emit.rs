//! The command `generate --emit STAGE`: one stage of the pipeline as text, instead of files.

use crate::refused;
use crate::words::made;
use compiler::pass;
use compiler::program::Program;
use generator::blocks::{self, Designed};
use generator::diagnostics::Report;
use generator::target::{self, TARGETS};
use std::borrow::Cow;

/// The stages, in the order of the pipeline; at the end the programs for targets with their own passes.
fn stages() -> Vec<&'static str> {
    let targets = TARGETS.iter().filter(|target| !target.passes.is_empty()).map(|target| target.name);
    ["parameters", "program"].into_iter().chain(pass::PASSES.map(|(name, _)| name)).chain(targets).collect()
}

/// The help text of the option.
#[must_use]
pub fn help() -> String {
    format!("Print one stage of the pipeline instead: {}", stages().join(", "))
}

/// A stage of every axis.
///
/// # Errors
/// There is no such stage.
pub fn text<'a>(axes: impl Iterator<Item = &'a Designed>, stage: &str) -> Result<String, Report> {
    if !stages().contains(&stage) {
        return Err(refused::no_such("--emit", "stage", stage, &stages()));
    }
    let of_axis = |designed: &Designed| match stage {
        "parameters" => {
            let (name, parameters) = (&designed.axis.name, designed.axis.canonical.trim_end());
            format!("# axis {name}: every effective parameter\n{parameters}\n")
        }
        "program" => programs(designed, None),
        pass => programs(designed, Some(pass)),
    };
    Ok(axes.map(of_axis).collect())
}

/// The programs of an axis after a pass, or for a target; with `None`, the output of the specialiser.
fn programs(designed: &Designed, last: Option<&str>) -> String {
    let programs = match last.and_then(target::named) {
        Some(target) => {
            made(blocks::blocks(designed)).iter().map(|block| target.program(block).map(Cow::into_owned)).collect()
        }
        None => blocks::of_axis(&designed.axis).map(|kind| kind.program(designed, last)).collect(),
    };
    let programs: Vec<Program> = made(programs);
    let text = |program: Program| {
        let (name, text) = (&designed.axis.name, program.to_string());
        format!("# axis {name}: {}\n{}\n", program.block, text.trim_end())
    };
    programs.into_iter().map(text).collect()
}
