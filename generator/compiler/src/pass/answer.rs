//! Assigns a condition directly to a flag if both branches of an `if` only store the answer.
//!
//! ```text
//! if a { flag := true } else { flag := false }   ->   flag := a
//! ```

use super::Defect;
use crate::program::{Expr, Program, Statement, Var, retain_mut};
use portable::Literal;

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    retain_mut(&mut program.step, &mut |statement| {
        if let Statement::If { condition, then, otherwise } = statement
            && let (Some((target, yes)), Some((other, no))) = (answer(then), answer(otherwise))
            && target == other
            && yes != no
        {
            let condition = std::mem::replace(condition, Expr::bool(true));
            *statement = Statement::Assign { target, value: if yes { condition } else { Expr::not(condition) } };
        }
        true
    });
    Ok(program)
}

/// The flag and the value that a branch assigns, if it does nothing else.
fn answer(branch: &[Statement]) -> Option<(Var, bool)> {
    match branch {
        [Statement::Assign { target, value: Expr::Literal(Literal::Bool(value)) }] => Some((*target, *value)),
        _ => None,
    }
}
