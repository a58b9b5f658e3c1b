//! Joins consecutive questions into one chain if at most one of them is true: different values of one integer.
//!
//! ```text
//! if n == 0 { x }                  if n == 0 { x }
//! if n == 1 { y }         ->       else if n == 1 { y }
//! if n > 1 { z }                   else if n > 1 { z }
//! ```
//!
//! A compiler can then jump to the one that is true.

use super::Defect;
use super::condition::{Comparison, Conditions};
use crate::program::{Expr, Program, Statement};

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    let mut step = std::mem::take(&mut program.step);
    in_list(&mut step, &Conditions::of(&program));
    program.step = step;
    Ok(program)
}

fn in_list(list: &mut Vec<Statement>, conditions: &Conditions<'_>) {
    list.iter_mut().for_each(|statement| statement.change_branches(|list| in_list(list, conditions)));
    let mut done: Vec<Statement> = Vec::new();
    // From the end, so that the rest of a chain is already one statement.
    for statement in std::mem::take(list).into_iter().rev() {
        match (statement, done.pop()) {
            (Statement::If { condition, then, otherwise }, Some(rest))
                if otherwise.is_empty() && is_chained(&condition, &then, &rest, conditions) =>
            {
                done.push(Statement::If { condition, then, otherwise: vec![rest] });
            }
            (statement, rest) => {
                done.extend(rest);
                done.push(statement);
            }
        }
    }
    done.reverse();
    *list = done;
}

/// Whether no question of the chain `rest` can be true where this one is, nor after its statements.
fn is_chained(condition: &Expr, then: &[Statement], rest: &Statement, conditions: &Conditions<'_>) -> bool {
    let Some(first) = conditions.comparison(condition) else { return false };
    let mut link = rest;
    loop {
        let Statement::If { condition, otherwise, .. } = link else { return false };
        if !conditions.comparison(condition).is_some_and(|other| are_apart(&first, &other)) {
            return false;
        }
        match &otherwise[..] {
            [] => return !then.iter().any(|statement| statement.writes(first.var)),
            [next] => link = next,
            _ => return false,
        }
    }
}

/// Whether both ask for values of one variable, and no value satisfies both.
fn are_apart(one: &Comparison, other: &Comparison) -> bool {
    let [(low, high), (from, to)] = [one.within, other.within];
    one.var == other.var && one.answer && other.answer && (high < from || to < low)
}
