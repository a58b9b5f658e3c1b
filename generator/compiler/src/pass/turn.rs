//! Removes the negation of a condition if both branches have statements: `if !a { x } else { y }` becomes `if a { y } else {
//! x }`.
//!
//! A chain `if !a { x } else if b { y } else ...` is unchanged: otherwise each further condition would be nested one level
//! deeper.

use super::Defect;
use crate::program::{Expr, Program, Statement, retain_mut};
use portable::Unary;

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    retain_mut(&mut program.step, &mut |statement| {
        if let Statement::If { condition, then, otherwise } = statement
            && let Expr::Unary(Unary::Not, positive) = condition
            && !then.is_empty()
            && !matches!(otherwise[..], [] | [Statement::If { .. }])
        {
            *condition = std::mem::replace(positive, Expr::bool(true));
            std::mem::swap(then, otherwise);
        }
        true
    });
    Ok(program)
}
