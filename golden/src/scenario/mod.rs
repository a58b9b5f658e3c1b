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

use crate::drive::{AtLimit, Oscillation, margins};
use crate::samples::Samples;
use crate::subject::Subject;
use generator::axis::{DriveModel, Enable};
use generator::blocks::{Block, Designed};
pub use nc::Mistake;
use nc::{Command, Program};

/// A scenario that was run.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// what the block got, and what its reference gave
    pub inputs: Samples,
    pub outputs: Samples,
    /// the blocks of the program, in their order
    pub steps: Vec<Step>,
    /// whether the loop with `v_add` oscillates
    pub oscillation: Oscillation,
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

/// Whether `v_add` acts in a loop that is stable with that drive: the block starts ON, and puts `v_add` out.
fn is_stable(designed: &Designed, subject: &Subject, drive: &DriveModel) -> bool {
    let acts = designed.axis.ipc.enable == Enable::On && subject.output("v_add").is_some();
    !acts || margins::margins(designed, drive).stable
}

/// Whether `v_add` is at its limit in this cycle.
fn is_limited(designed: &Designed, subject: &Subject) -> bool {
    subject.get("v_add_calculated").abs() >= designed.axis.ipc.limit() * (1.0 - ROUNDING) && subject.get("v_add") != 0.0
}

/// Longer scenarios are a mistake of their program.
const MOST: usize = 200_000;
/// Within which a limit is one in single precision.
const ROUNDING: f64 = 1e-6;

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

/// The same in a loop that oscillates, which may be why.
fn oscillates(mistake: Mistake) -> Mistake {
    let instead = "weights with which the loop is stable: it is not, and `axgen analyze` prints the largest ones";
    Mistake { instead: instead.to_owned(), ..mistake }
}

/// An axis in its loop.
trait InLoop {
    /// Does what a command asks for; is back when that is done.
    fn perform(&mut self, command: &Command, line: usize) -> Result<(), Mistake>;

    /// Some cycles without a command.
    fn rest(&mut self, line: usize) -> Result<(), Mistake>;

    fn subject(&self) -> &Subject;

    fn at_limit(&self) -> &AtLimit;
}

/// Runs the blocks of a program one after the other, between rests, in a loop that is stable or not.
fn perform_all(closed: &mut impl InLoop, program: &Program, is_stable: bool) -> Result<Scenario, Mistake> {
    let steps = steps(closed, program).map_err(|mistake| if is_stable { mistake } else { oscillates(mistake) })?;
    let Subject { inputs, outputs, .. } = closed.subject();
    let oscillation = Oscillation { is_stable, at_limit: closed.at_limit().time() };
    Ok(Scenario { inputs: inputs.clone(), outputs: outputs.clone(), steps, oscillation })
}

fn steps(closed: &mut impl InLoop, program: &Program) -> Result<Vec<Step>, Mistake> {
    let lines = |block: Option<&nc::Block>| block.map_or(1, |block| block.line);
    closed.rest(lines(program.blocks.first()))?;
    let mut steps = Vec::with_capacity(program.blocks.len());
    for block in &program.blocks {
        let from = closed.subject().inputs.len();
        block.commands.iter().try_for_each(|command| closed.perform(command, block.line))?;
        steps.push(Step { line: block.line, number: block.number, from, to: closed.subject().inputs.len() });
    }
    closed.rest(lines(program.blocks.last()))?;
    Ok(steps)
}
