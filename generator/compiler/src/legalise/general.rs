//! Leaves out the fast path of a block with parameter sets: every cycle takes the path of any cycle, which has the same result.
//! Structured Text is read and loaded by people, and half of the statements of a cycle would be there twice.

use super::apart::last_else;
use crate::pass::Defect;
use crate::program::Program;

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    if program.usual_first
        && program.has_set()
        && let Some(any_cycle) = last_else(&mut program.step).map(std::mem::take)
    {
        program.step.pop();
        program.step.extend(any_cycle);
    }
    Ok(program)
}
