//! Does what a flag asks for where the flag is raised, if that is one place.
//!
//! ```text
//! if a { flag := true; n := 2 } else { flag := false; n := 0 }      if a { flag := true; n := 2; x := n } else { ... }
//! ...                                                          ->   ...
//! if flag { x := n }
//! ```

use super::Defect;
use crate::program::{Expr, Program, Statement, Var};
use portable::Literal;

/// Runs the pass.
///
/// # Errors
/// None.
pub fn run(mut program: Program) -> Result<Program, Defect> {
    program.step = in_list(program.step);
    Ok(program)
}

/// Treats a list, inner lists first.
fn in_list(list: Vec<Statement>) -> Vec<Statement> {
    let mut done: Vec<Statement> = Vec::new();
    for statement in list {
        match statement {
            Statement::If { condition, then, otherwise } => {
                let (then, otherwise) = (in_list(then), in_list(otherwise));
                let flag = match condition {
                    Expr::Var(flag @ Var::Local(_)) if otherwise.is_empty() => Some(flag),
                    _ => None,
                };
                if !flag.is_some_and(|flag| places(&done, flag, &then) == Some(1) && !is_set(&then)) {
                    done.push(Statement::If { condition, then, otherwise });
                } else if let Some(flag) = flag {
                    put(&mut done, flag, then);
                }
            }
            other => done.push(other),
        }
    }
    done
}

/// Whether nothing but a known value is assigned: the pass `sunk` does that wherever the flag is raised.
fn is_set(effect: &[Statement]) -> bool {
    matches!(effect, [Statement::Assign { value: Expr::Literal(_), .. }])
}

/// In how many lists the flag may be raised at whose end the effect can stand; nothing, if it cannot.
fn places(list: &[Statement], flag: Var, effect: &[Statement]) -> Option<usize> {
    let last = list.iter().rposition(|statement| writes(statement, flag))?;
    match &list[last] {
        Statement::Assign { value, .. } => Some(usize::from(*value != Expr::Literal(Literal::Bool(false)))),
        Statement::If { then, otherwise, .. } if !list[last + 1..].iter().any(|later| disturbs(later, effect)) => {
            Some(places(then, flag, effect)? + places(otherwise, flag, effect)?)
        }
        _ => None,
    }
}

/// Puts the effect at the end of the list in which the flag is raised.
fn put(list: &mut Vec<Statement>, flag: Var, effect: Vec<Statement>) {
    let last = list.iter().rposition(|statement| writes(statement, flag));
    match last.map(|last| &mut list[last]) {
        Some(Statement::If { then, otherwise, .. }) => {
            let raised = if places(then, flag, &[]) == Some(1) { then } else { otherwise };
            put(raised, flag, effect);
        }
        Some(Statement::Assign { value, .. }) if *value != Expr::Literal(Literal::Bool(true)) => {
            let condition = if is_fixed(value) { value.clone() } else { Expr::Var(flag) };
            list.push(Statement::If { condition, then: effect, otherwise: Vec::new() });
        }
        _ => list.extend(effect),
    }
}

/// Whether nothing can change the value any more.
fn is_fixed(value: &Expr) -> bool {
    let mut fixed = true;
    value.variables(&mut |var| fixed &= !matches!(var, Var::Output(_) | Var::State(_)));
    fixed
}

fn writes(statement: &Statement, var: Var) -> bool {
    let mut found = false;
    statement.assignments(&mut |target, _| found |= target == var);
    found
}

/// Whether it matters which of the two comes first.
fn disturbs(later: &Statement, effect: &[Statement]) -> bool {
    let mut found = false;
    later.assignments(&mut |target, _| found |= effect.iter().any(|statement| statement.mentions(target)));
    effect.iter().for_each(|statement| statement.assignments(&mut |target, _| found |= later.mentions(target)));
    found
}
