//! Asks in the positive where both answers lead to something: `if !a { x } else { y }` becomes `if a { y } else { x }`.
//!
//! A chain `if !a { x } else if b { y } else ...` stays: turned, each of its questions would stand one level deeper.

use super::Defect;
use crate::program::{Expr, Program, Statement};
use portable::Unary;

/// Runs the pass.
///
/// # Errors
/// None.
pub fn run(mut program: Program) -> Result<Program, Defect> {
    program.step = in_list(program.step);
    Ok(program)
}

fn in_list(list: Vec<Statement>) -> Vec<Statement> {
    list.into_iter()
        .map(|statement| match statement {
            Statement::If { condition, then, otherwise } => turned(condition, in_list(then), in_list(otherwise)),
            other => other,
        })
        .collect()
}

fn turned(condition: Expr, then: Vec<Statement>, otherwise: Vec<Statement>) -> Statement {
    match condition {
        Expr::Unary(Unary::Not, condition)
            if !then.is_empty() && !matches!(otherwise[..], [] | [Statement::If { .. }]) =>
        {
            Statement::If { condition: *condition, then: otherwise, otherwise: then }
        }
        condition => Statement::If { condition, then, otherwise },
    }
}
