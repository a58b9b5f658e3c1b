//! Scenarios: an NC program and an axis generate the inputs of a block, in a closed loop with the block's reference and a
//! simple drive. No file, no engine other than the reference.
//!
//! ```text
//! program -> interpreter (spindle, path) -> interpolator (machine::profile) -> reference of the block -> drive ->
//! actual values -> ...
//! ```
//!
//! A block of a program ends when its commands are finished. The result is the samples that the block got. They are rounded
//! as in controllers: positions to 0.0001 deg or 0.1 um, velocities to 0.001 deg/s or um/s, so that decimal text contains
//! them exactly. `docs/scenarios.md` describes the model.
//!
//! The profiles come from a library, which may change. Therefore the samples are stored, not the program alone.

mod in_loop;
mod notes;
mod path;
pub mod picture;
mod program_axis;
mod spindle;
pub(crate) mod spindle_machine;

use crate::drive::Oscillation;
use crate::samples::Samples;
use generator::blocks::{Block, Designed};
pub use nc::Mistake;
pub use notes::Note;

/// The result of a scenario.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// the inputs of the block, and the outputs of its reference
    pub inputs: Samples,
    pub outputs: Samples,
    /// the blocks of the program, in their order
    pub steps: Vec<Step>,
    /// whether the loop with `v_add` oscillates
    pub oscillation: Oscillation,
    /// parts of the program that do not act as written, in the order of its lines
    pub notes: Vec<Note>,
}

/// The options of a program.
#[derive(Clone, Debug)]
pub struct Options {
    /// the program's axis that the axis of the set follows; `None` for the axis of its name
    pub program_axis: Option<String>,
    /// the scenario stops after this number of cycles, with a note
    pub cycles: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { program_axis: None, cycles: CYCLES }
    }
}

/// Default limit of the number of cycles.
pub const CYCLES: usize = 200_000;
/// The largest limit: more does not fit into every memory.
pub const MOST: usize = 5_000_000;

/// The times of a block of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// line of the file, from 1
    pub line: usize,
    /// the number after `N`
    pub number: Option<u32>,
    /// its samples: the first one, and the first one after the block
    pub from: usize,
    pub to: usize,
}

/// The name of the block for a scenario: the changeover of a spindle, else the block with everything.
#[must_use]
pub fn usual_block(names: &[&'static str]) -> Option<&'static str> {
    let wanted = ["spindle", "axis", "position_control", "feedforward"];
    wanted.into_iter().find(|name| names.contains(name)).or(names.first().copied())
}

/// Runs a program on an axis.
///
/// # Errors
/// All errors in the program, or in the program for this axis.
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

/// The error in a block of a program on this axis.
fn refused(line: usize, found: impl Into<String>, allowed: impl Into<String>, instead: impl Into<String>) -> Mistake {
    Mistake { line, column: 1, found: found.into(), allowed: allowed.into(), instead: instead.into() }
}
