//! Assigns every negated condition to a BOOL: one compiler translates `NOT` before an expression wrongly.
//!
//! ```text
//! IF NOT ((mode = 1) OR (mode = 2)) THEN   ->   mode_condition := (mode = 1) OR (mode = 2); IF NOT mode_condition THEN
//! ```

use super::before::{self, Before};
use crate::pass::Defect;
use crate::program::{Expr, Program, Type, Var};
use portable::{Binary, Intrinsic, Literal, Unary};
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

/// The name of a condition: from the variable in it, if there is only one, and from the limit that it compares it with.
fn name_of(condition: &Expr, before: &Before<'_>) -> String {
    let mut asked = BTreeSet::new();
    condition.variables(&mut |var| {
        if !matches!(var, Var::Constant(_)) {
            asked.insert(var);
        }
    });
    let mut asked = asked.into_iter();
    match (asked.next(), asked.next()) {
        (Some(only), None) => {
            let path = before.program.path(only);
            match limit(condition) {
                Some(Expr::Var(limit)) => {
                    format!("{path}_within_{}", before.program.path(*limit).rsplit('.').next().unwrap_or_default())
                }
                Some(_) => format!("{path}_within_limit"),
                None if is_zero(condition) => format!("{path}_is_zero"),
                None => format!("{path}_condition"),
            }
        }
        _ => "condition".to_owned(),
    }
}

/// Whether a condition asks if a variable is 0.
fn is_zero(condition: &Expr) -> bool {
    let Expr::Binary(Binary::Equal, _, with) = condition else { return false };
    matches!(**with, Expr::Literal(Literal::F64(0.0) | Literal::F32(0.0)))
}

/// The limit of a condition that a magnitude is within a limit.
fn limit(condition: &Expr) -> Option<&Expr> {
    match condition {
        Expr::Intrinsic(Intrinsic::InRange | Intrinsic::Within, operands) => operands.last(),
        Expr::Binary(Binary::And, lower, upper) => match (&**lower, &**upper) {
            (Expr::Binary(Binary::LessEqual, _, value), Expr::Binary(Binary::LessEqual, same, limit))
                if value == same =>
            {
                Some(limit)
            }
            _ => None,
        },
        _ => None,
    }
}
