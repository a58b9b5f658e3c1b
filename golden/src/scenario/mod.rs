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

mod notes;
mod path;
pub mod picture;
mod program_axis;
mod spindle;
pub(crate) mod spindle_machine;

use crate::samples::Samples;
use crate::subject::Subject;
use generator::blocks::{Block, Designed};
use generator::codes;
pub use nc::Mistake;
use nc::Program;
pub use notes::Note;

/// A scenario that was run.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// what the block got, and what its reference gave
    pub inputs: Samples,
    pub outputs: Samples,
    /// the blocks of the program, in their order
    pub steps: Vec<Step>,
    /// what of the program does not act as it says, in the order of its lines
    pub notes: Vec<Note>,
}

/// How a program is run.
#[derive(Clone, Debug)]
pub struct Options {
    /// the program's axis that the axis of the set follows; none: that of its name
    pub program_axis: Option<String>,
    /// the scenario stops after this number of cycles, and says so
    pub cycles: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { program_axis: None, cycles: CYCLES }
    }
}

/// A scenario has at most this number of cycles, unless another one is asked for.
pub const CYCLES: usize = 200_000;
/// The most that can be asked for: more does not fit into memory everywhere.
pub const MOST: usize = 5_000_000;

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
pub fn run(text: &str, designed: &Designed, block: &Block, options: &Options) -> Result<Scenario, Vec<Mistake>> {
    let program = nc::read(text)?;
    let scenario = if ["spindle", "spindle_axis"].contains(&block.program.block) {
        spindle::run(&program, designed, block, options)
    } else {
        path::run(&program, designed, block, options)
    };
    let mut scenario = scenario.map_err(|mistake| vec![mistake])?;
    scenario.notes.extend(program.passed.iter().map(notes::of));
    scenario.notes.sort_by_key(|note| note.line);
    Ok(scenario)
}

/// One cycle of the block, in which it must not have an error.
fn cycle(subject: &mut Subject, line: usize) -> Result<(), Mistake> {
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

/// Runs the blocks of a program one after the other until the scenario is full, and notes when each acted.
fn steps(
    program: &Program,
    mut perform: impl FnMut(&nc::Block) -> Result<Option<(usize, usize)>, Mistake>,
) -> Result<Vec<Step>, Mistake> {
    let step = |block: &nc::Block| {
        let range = perform(block).transpose()?;
        Some(range.map(|(from, to)| Step { line: block.line, number: block.number, from, to }))
    };
    program.blocks.iter().map_while(step).collect()
}

/// That the program is longer than its scenario.
fn stopped(program: &Program, steps: &[Step], cycles: usize, cycle_time: f64) -> Note {
    let line = steps.last().map_or(1, |step| step.line);
    let last = program.blocks.last().map_or(line, |block| block.line);
    let seconds = cycles as f64 * cycle_time;
    let found = format!(
        "a program that goes on: the scenario stops after {cycles} cycles, {seconds:.3} s, in line {line} of {last}"
    );
    let instead = format!("--cycles with more of them, up to {MOST}, or a shorter program");
    Note::new(codes::NC_STOPPED, line, found, instead)
}
