//! Moves the statements that depend on a flag to the place where the flag becomes true, if there is only one such place.
//!
//! ```text
//! if a { flag := true; n := 2 } else { flag := false; n := 0 }      if a { flag := true; n := 2; x := n } else { ... }
//! ...                                                          ->   ...
//! if flag { x := n }
//! ```

use super::Defect;
use crate::program::{Expr, Program, Statement, Var};

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    program.step = in_list(program.step);
    Ok(program)
}

fn in_list(list: Vec<Statement>) -> Vec<Statement> {
    let mut done: Vec<Statement> = Vec::new();
    for mut statement in list {
        statement.change_branches(|list| *list = in_list(std::mem::take(list)));
        match statement {
            Statement::If { condition: Expr::Var(flag @ Var::Local(_)), then, otherwise }
                if otherwise.is_empty() && places(&done, flag, &then) == Some(1) && !is_set(&then) =>
            {
                put(&mut done, flag, then);
            }
            other => done.push(other),
        }
    }
    done
}

/// Whether only a known value is assigned: the pass `sunk` moves that to every place that sets the flag.
fn is_set(effect: &[Statement]) -> bool {
    matches!(effect, [Statement::Assign { value: Expr::Literal(_), .. }])
}

/// The number of lists in which the flag may become true, so that the effect can be placed at their end; `None` if that is
/// impossible.
fn places(list: &[Statement], flag: Var, effect: &[Statement]) -> Option<usize> {
    let last = list.iter().rposition(|statement| statement.writes(flag))?;
    match &list[last] {
        Statement::Assign { value, .. } => Some(usize::from(*value != Expr::bool(false))),
        Statement::If { then, otherwise, .. } if !list[last + 1..].iter().any(|later| disturbs(later, effect)) => {
            Some(places(then, flag, effect)? + places(otherwise, flag, effect)?)
        }
        _ => None,
    }
}

/// Appends the effect to the list in which the flag becomes true.
fn put(list: &mut Vec<Statement>, flag: Var, effect: Vec<Statement>) {
    let last = list.iter().rposition(|statement| statement.writes(flag));
    match last.map(|last| &mut list[last]) {
        Some(Statement::If { then, otherwise, .. }) => {
            let raised = if places(then, flag, &[]) == Some(1) { then } else { otherwise };
            put(raised, flag, effect);
        }
        Some(Statement::Assign { value, .. }) if *value != Expr::bool(true) => {
            let condition = if is_fixed(value) { value.clone() } else { Expr::Var(flag) };
            list.push(Statement::If { condition, then: effect, otherwise: Vec::new() });
        }
        _ => list.extend(effect),
    }
}

/// Whether no later statement can change the value.
fn is_fixed(value: &Expr) -> bool {
    let mut fixed = true;
    value.variables(&mut |var| fixed &= !matches!(var, Var::Output(_) | Var::State(_)));
    fixed
}

/// Whether the order of the two matters.
fn disturbs(later: &Statement, effect: &[Statement]) -> bool {
    let mut found = false;
    later.assignments(&mut |target, _| found |= effect.iter().any(|statement| statement.mentions(target)));
    effect.iter().for_each(|statement| statement.assignments(&mut |target, _| found |= later.mentions(target)));
    found
}
