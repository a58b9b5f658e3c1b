//! Scenarios: an NC program and an axis make the inputs of a block, in a closed loop with the block's reference and a simple drive.
//! No file, no engine but the reference.
//!
//! ```text
//! program -> interpreter (spindle, path) -> interpolator (machine::profile) -> reference of the block -> drive -> actual values -> ...
//! ```
//!
//! A block of a program is over when what it asks for is done. What comes out are the samples that the block got. They are rounded
//! as controllers have them: positions to 0.0001 deg or 0.1 um, velocities to 0.001 deg/s or um/s, so that decimal text holds them
//! exactly. `docs/scenarios.md` describes the model.
//!
//! The profiles come from a library, which may change. So the samples are what is kept; a program is how they were made.

mod path;
pub mod picture;
mod spindle;
pub(crate) mod spindle_machine;

use crate::samples::Samples;
use crate::subject::Subject;
use generator::blocks::{Block, Designed};
pub use nc::Mistake;
use nc::Program;

/// A scenario that was run.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// what the block got, and what its reference gave
    pub inputs: Samples,
    pub outputs: Samples,
    /// the blocks of the program, in their order
    pub steps: Vec<Step>,
}

/// When a block of the program acted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// line of the file, from 1
    pub line: usize,
    /// behind `N`
    pub number: Option<u32>,
    /// its samples: the first one, and the first one behind it
    pub from: usize,
    pub to: usize,
}

/// The block of an axis that a scenario is for, by its name: the changeover of a spindle, else the one with everything.
#[must_use]
pub fn usual_block(names: &[&'static str]) -> Option<&'static str> {
    let wanted = ["spindle", "axis", "position_control", "feedforward"];
    wanted.into_iter().find(|name| names.contains(name)).or(names.first().copied())
}

/// Runs a program on an axis.
///
/// # Errors
/// What is wrong with the program, or with the program for this axis.
pub fn run(text: &str, designed: &Designed, block: &Block) -> Result<Scenario, Vec<Mistake>> {
    let program = nc::read(text)?;
    let scenario = if ["spindle", "spindle_axis"].contains(&block.program.block) {
        spindle::run(&program, designed, block)
    } else {
        path::run(&program, designed, block)
    };
    scenario.map_err(|mistake| vec![mistake])
}

/// Longer scenarios are a mistake of their program.
const MOST: usize = 200_000;

/// One cycle of the block, in which it must not have an error.
fn cycle(subject: &mut Subject, line: usize) -> Result<(), Mistake> {
    if subject.inputs.len() >= MOST {
        let found = format!("a block that is not over after {MOST} cycles of the scenario");
        return Err(refused(line, found, "a scenario that ends", "another program, or a longer cycle time"));
    }
    subject.step();
    if subject.get("fault") != 0.0 {
        let found = format!("error {} of the block at sample {}", subject.get("error_id"), subject.inputs.len() - 1);
        let instead = "other parameters, or another program; `axgen explain` says what the error means";
        return Err(refused(line, found, "a scenario without an error", instead));
    }
    Ok(())
}

/// What is wrong with a block of a program on this axis.
fn refused(line: usize, found: impl Into<String>, allowed: impl Into<String>, instead: impl Into<String>) -> Mistake {
    Mistake { line, column: 1, found: found.into(), allowed: allowed.into(), instead: instead.into() }
}

/// Runs the blocks of a program one after the other, and notes when.
fn steps(
    program: &Program,
    mut perform: impl FnMut(&nc::Block) -> Result<(usize, usize), Mistake>,
) -> Result<Vec<Step>, Mistake> {
    let step = |block: &nc::Block| {
        let (from, to) = perform(block)?;
        Ok(Step { line: block.line, number: block.number, from, to })
    };
    program.blocks.iter().map(step).collect()
}
