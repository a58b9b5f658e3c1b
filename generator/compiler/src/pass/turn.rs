//! Removes the negation of a condition if both branches have statements: `if !a { x } else { y }` becomes `if a { y } else {
//! x }`.
//!
//! A chain `if !a { x } else if b { y } else ...` is unchanged: otherwise each further condition would be nested one level
//! deeper.

use super::Defect;
use crate::program::{Expr, Program, Statement, rewrite};
use portable::Unary;

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    rewrite(&mut program.step, &mut |statement, list| {
        list.push(match statement {
            Statement::If { condition: Expr::Unary(Unary::Not, condition), then, otherwise }
                if !then.is_empty() && !matches!(otherwise[..], [] | [Statement::If { .. }]) =>
            {
                Statement::If { condition: *condition, then: otherwise, otherwise: then }
            }
            other => other,
        });
    });
    Ok(program)
}
