//! `axgen generate --emit STAGE`: one stage of the pipeline as text, instead of files.

use crate::exit::Exit;
use generator::axis::Axis;
use generator::{block, pass};

/// Prints a stage of every axis.
#[expect(clippy::print_stdout, reason = "what was asked for")]
pub fn run<'a>(axes: impl Iterator<Item = &'a Axis>, stage: &str) -> Result<Exit, Exit> {
    let passes = pass::PASSES.map(|(name, _)| name);
    let stages = || ["parameters", "program"].into_iter().chain(passes).collect::<Vec<_>>().join(", ");
    for axis in axes {
        let name = &axis.name;
        match stage {
            "parameters" => println!("# axis {name}: every effective parameter\n{}", axis.canonical.trim_end()),
            "program" => print(axis, None),
            stage if passes.contains(&stage) => print(axis, Some(stage)),
            other => return Err(Exit::input(format!("no stage `{}`; there is: {}", other.escape_default(), stages()))),
        }
    }
    Ok(Exit::Done)
}

/// Prints the programs of an axis after a pass; none: as the specialiser gives them.
#[expect(clippy::print_stdout, reason = "what was asked for")]
fn print(axis: &Axis, last: Option<&str>) {
    let programs = block::programs(axis, last).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"));
    for program in programs {
        println!("# axis {}: {}\n{}", axis.name, program.block, generator::dump::text(&program).trim_end());
    }
}
