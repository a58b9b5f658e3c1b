//! Removes the operation that forces a read of the state from memory: Structured Text has no registers.

use crate::pass::Defect;
use crate::program::{Expr, Program, map_expressions};
use portable::Intrinsic;

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    map_expressions(&mut program.step, &mut |expr| {
        expr.change(&mut |part| {
            if let Expr::Intrinsic(Intrinsic::Stored, operands) = part
                && let Some(operand) = operands.pop()
            {
                *part = operand;
            }
        });
    });
    Ok(program)
}
