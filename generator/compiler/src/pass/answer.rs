//! Assigns a condition directly to a flag if both branches of an `if` only store the answer.
//!
//! ```text
//! if a { flag := true } else { flag := false }   ->   flag := a
//! ```

use super::Defect;
use crate::program::{Expr, Program, Statement, Var, rewrite};
use portable::Literal;

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    rewrite(&mut program.step, &mut |statement, list| {
        list.push(match statement {
            Statement::If { condition, then, otherwise } => match (answer(&then), answer(&otherwise)) {
                (Some((target, yes)), Some((other, no))) if target == other && yes != no => {
                    Statement::Assign { target, value: if yes { condition } else { Expr::not(condition) } }
                }
                _ => Statement::If { condition, then, otherwise },
            },
            other => other,
        });
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
