//! Assigns every negated condition to a BOOL: one compiler translates `NOT` before an expression wrongly.
//!
//! ```text
//! IF NOT ((mode = 1) OR (mode = 2)) THEN   ->   mode_condition := (mode = 1) OR (mode = 2); IF NOT mode_condition THEN
//! ```

use super::before::{self, Before};
use crate::pass::Defect;
use crate::program::{Expr, Program, Type, Var};
use portable::Unary;
use std::collections::BTreeSet;

pub(super) fn run(program: Program) -> Result<Program, Defect> {
    Ok(before::run(program, |expr, before| expr.change(&mut |part| name(part, before))))
}

fn name(part: &mut Expr, before: &mut Before<'_>) {
    if let Expr::Unary(Unary::Not, condition) = part
        && !matches!(**condition, Expr::Var(_))
    {
        let name = name_of(condition, before);
        before.take(condition, name, Type::Bool);
    }
}

/// The name of a condition: from the variable in it, if there is only one.
fn name_of(condition: &Expr, before: &Before<'_>) -> String {
    let mut asked = BTreeSet::new();
    condition.variables(&mut |var| {
        if !matches!(var, Var::Constant(_)) {
            asked.insert(var);
        }
    });
    let mut asked = asked.into_iter();
    match (asked.next(), asked.next()) {
        (Some(only), None) => format!("{}_condition", before.program.path(only)),
        _ => "condition".to_owned(),
    }
}
