//! Passes that make a program expressible in a language. A target lists the passes that it needs, and `verify` runs after
//! the last of them.

mod apart;
mod axis_program;
mod before;
mod bound;
mod choose;
mod copied;
mod early;
mod enable;
mod ends;
mod general;
mod guarded;
mod joined;
mod nearest;
mod negation;
mod operands;
mod presumed;
mod repeated;
mod rows;
mod settle;
mod share;
mod single;
mod start;
mod task;
mod whole;

pub use axis_program::{AxisProgram, RealInput, for_axis};
pub use enable::{Cycle, NOTICE, NOTICES, ONLY_NOTICES, RENAMED, meanings};
pub use nearest::nearly_half;

use crate::pass::{self, Defect, Stage};
use crate::program::Program;
use std::borrow::Cow;

/// The passes for C and Rust.
pub const WITH_OUTPUTS: &[Stage] = &[
    ("settled", settle::run),
    ("early", early::run),
    ("ends", ends::run),
    ("indexed", rows::run),
    ("chosen", choose::run),
    ("apart", apart::run),
    ("whole", whole::run),
];

/// The passes for any compiler of Structured Text: digits of an LREAL may be in an expression. Not every one has arrays in an
/// instance.
pub const WITH_DIGITS: &[Stage] = &[
    ("general", general::run),
    ("settled", settle::run),
    ("copied", copied::run),
    (presumed::NAME, presumed::run),
    ("joined", joined::run),
    ("started", start::run),
    ("rounded", nearest::run),
    ("bounded", bound::run_digits),
    ("negated", negation::run),
    ("named", operands::run_single),
    ("single", single::run),
    ("chosen", choose::run),
    ("shared", share::run),
    ("repeated", repeated::run),
];

/// The passes for its dialects with declared constants, with the signals of PLCopen around the block.
pub const WITH_ENABLE: &[Stage] = &with_enable(("bounded", bound::run), ("named", operands::run_single));

/// The passes for SCL: digits need not be LREAL, so numbers have names.
pub const WITH_NAMES: &[Stage] = &with_enable(("bounded", bound::run_digits), ("all named", operands::run));

const fn with_enable(bounded: Stage, named: Stage) -> [Stage; 17] {
    [
        ("general", general::run),
        ("enabled", enable::run),
        ("settled", settle::run),
        ("copied", copied::run),
        (presumed::NAME, presumed::run),
        ("joined", joined::run),
        ("started", start::run),
        ("guarded", guarded::run),
        ("rounded", nearest::run),
        bounded,
        ("negated", negation::run),
        named,
        ("single", single::run),
        ("indexed", rows::run),
        ("chosen", choose::run),
        ("shared", share::run),
        ("repeated", repeated::run),
    ]
}

/// The passes for TwinCAT: its runtime counts the cycles of a task.
pub const WITH_TASK: &[Stage] = &{
    let mut passes = [("filled", task::run as fn(Program) -> Result<Program, Defect>); WITH_ENABLE.len() + 1];
    let mut at = 0;
    while at < WITH_ENABLE.len() {
        passes[at + 1] = WITH_ENABLE[at];
        at += 1;
    }
    passes
};

/// The passes that change a program.
pub fn needed<'s>(program: &Program, passes: &'s [Stage]) -> &'s [Stage] {
    match passes {
        [("filled", _), others @ ..] if !task::is_needed(program) => others,
        passes => passes,
    }
}

/// Runs the passes of a target over a verified program, and verifies the result.
///
/// # Errors
/// The first defect.
pub fn run<'p>(program: &'p Program, passes: &[Stage]) -> Result<Cow<'p, Program>, Defect> {
    if passes.is_empty() {
        return Ok(Cow::Borrowed(program));
    }
    let legal = passes.iter().try_fold(program.clone(), |program, (_, pass)| pass(program))?;
    settle::verify(&legal)?;
    rows::verify(&legal)?;
    let assigns_again = passes.iter().any(|(name, _)| *name == presumed::NAME);
    let verify = if assigns_again { pass::verify_assigned_again } else { pass::verify };
    verify(legal).map(Cow::Owned)
}
