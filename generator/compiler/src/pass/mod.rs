//! The passes over a [`Program`], one per file, and the order in which they run.

mod answer;
mod chain;
mod coalesce;
mod condition;
mod dead;
mod facts;
mod identity;
mod known;
pub(crate) mod prune;
mod sink;
mod thread;
mod turn;
mod typing;
mod verify;

pub(crate) use verify::assigned_again as verify_assigned_again;
pub use verify::run as verify;

use crate::program::Program;
use std::fmt;

/// A program that breaks the rules: a defect of a block or of a pass, never of an input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Defect {
    pub pass: &'static str,
    pub message: String,
}

impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.pass, self.message)
    }
}

impl std::error::Error for Defect {}

pub(crate) type Pass = fn(Program) -> Result<Program, Defect>;

/// A pass with the name of its result for `--emit`.
pub type Stage = (&'static str, Pass);

/// The stages after specialisation, in their order.
pub const PASSES: [Stage; 12] = [
    ("typed", typing::run),
    ("identity", identity::run),
    ("known", known::run),
    ("threaded", thread::run),
    ("answered", answer::run),
    ("live", dead::run),
    ("coalesced", coalesce::run),
    ("sunk", sink::run),
    ("chained", chain::run),
    ("turned", turn::run),
    ("pruned", prune::run),
    ("verified", verify::run),
];

/// Runs the passes up to the named one, or all of them.
///
/// # Errors
/// The first defect.
pub fn run(mut program: Program, last: Option<&str>) -> Result<Program, Defect> {
    for (name, pass) in PASSES {
        program = pass(program)?;
        if last == Some(name) {
            break;
        }
    }
    Ok(program)
}
