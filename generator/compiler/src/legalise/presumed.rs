//! Assigns to a local, before the branches, the value that most branches leave in it; these branches then need not assign
//! it. The text in Structured Text becomes shorter, and states the usual value once.
//!
//! ```text
//! if a { x := 1 } else if b { x := 0 } else { x := 0 }   ->   x := 0; if a { x := 1 }
//! ```
//!
//! A local is then assigned again on some paths. Nothing reads it before, so no value changes.

use crate::pass::Defect;
use crate::program::{Expr, Program, Statement, Var, close_up};
use portable::{Binary, Unary};

/// The name of the pass: if it has run, the last verification permits a second assignment of a local.
pub(super) const NAME: &str = "presumed";

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let mut done = vec![false; program.locals.len()];
    in_list(&mut program.step, &mut done);
    Ok(program)
}

fn in_list(list: &mut Vec<Statement>, done: &mut [bool]) {
    let mut at = 0;
    while at < list.len() {
        let before = presumed(&list[at], done);
        let does_something = before.iter().all(|known| leave_out_inside(&mut list[at], &|inner| inner == known));
        if does_something {
            list[at].change_branches(|inner| in_list(inner, done));
        }
        let next = at + before.len() + usize::from(does_something);
        if !before.is_empty() {
            list.splice(at..at + usize::from(!does_something), before);
        }
        at = next;
    }
}

/// The assignments to the locals that every path through a statement assigns, with the value that at least two of its branches
/// leave in them.
fn presumed(statement: &Statement, done: &mut [bool]) -> Vec<Statement> {
    if !matches!(statement, Statement::If { .. }) {
        return Vec::new();
    }
    let mut found: Vec<(usize, Vec<(&Expr, usize)>)> = Vec::new();
    statement.assignments(&mut |target, value| {
        let Var::Local(local) = target else { return };
        if done[local] || !is_fixed(value) {
            return;
        }
        let known = found.iter().position(|(other, _)| *other == local).unwrap_or_else(|| {
            found.push((local, Vec::new()));
            found.len() - 1
        });
        let values = &mut found[known].1;
        match values.iter_mut().find(|(other, _)| *other == value) {
            Some((_, times)) => *times += 1,
            None => values.push((value, 1)),
        }
    });
    let mut chosen = Vec::new();
    for (local, values) in found {
        let is_known = |value: &Expr| !matches!(value, Expr::Var(var) if statement.writes(*var));
        let most = values.iter().filter(|(value, times)| *times > 1 && is_known(value));
        // The first of several values: `max_by_key` alone would take the last.
        let most = most.rev().max_by_key(|(_, times)| *times);
        if let Some((value, _)) = most
            && always(statement, Var::Local(local))
        {
            done[local] = true;
            chosen.push(Statement::Assign { target: Var::Local(local), value: (*value).clone() });
        }
    }
    chosen
}

/// Whether no statement can change the value after it was computed.
pub(super) fn is_fixed(value: &Expr) -> bool {
    matches!(value, Expr::Literal(_) | Expr::Var(Var::Constant(_) | Var::Local(_) | Var::Input(_)))
}

/// Whether every path through a statement assigns the local.
fn always(statement: &Statement, local: Var) -> bool {
    match statement {
        Statement::Assign { target, .. } => *target == local,
        Statement::Note(_) => false,
        Statement::If { .. } | Statement::Choose { .. } | Statement::Apart(_) => {
            statement.branches().all(|list| list.iter().any(|inner| always(inner, local)))
        }
    }
}

/// Removes these assignments from a list and its inner lists. A branch with a comment keeps a statement: Structured Text does
/// not permit a branch of comments only.
pub(super) fn leave_out(list: &mut Vec<Statement>, is_it: &dyn Fn(&Statement) -> bool) {
    let others = |list: &[Statement]| list.iter().filter(|inner| !matches!(inner, Statement::Note(_))).count();
    let removes = list.iter().any(is_it) && (list.len() == 1 || others(list) > 1);
    list.retain_mut(|statement| !(removes && is_it(statement)) && leave_out_inside(statement, is_it));
}

/// Removes these assignments from the branches of a statement; returns whether it still does something.
fn leave_out_inside(statement: &mut Statement, is_it: &dyn Fn(&Statement) -> bool) -> bool {
    statement.change_branches(|inner| leave_out(inner, is_it));
    close_up(statement, opposite)
}

/// The negation of a condition; an equality or a negation is inverted.
fn opposite(condition: Expr) -> Expr {
    match condition {
        Expr::Unary(Unary::Not, operand) => *operand,
        Expr::Binary(Binary::Equal, left, right) => Expr::Binary(Binary::NotEqual, left, right),
        Expr::Binary(Binary::NotEqual, left, right) => Expr::Binary(Binary::Equal, left, right),
        other => Expr::not(other),
    }
}
