//! Removes questions with a known answer: from the enclosing branch, from a previous assignment, or from a previous
//! question.
//!
//! ```text
//! if a || b { if a { x } else { if b { y } else { z } } }   ->   if a || b { if a { x } else { y } }
//! ```

use super::Defect;
use super::condition::{Condition, Conditions, Id};
use super::facts::Facts;
use crate::program::{Expr, Program, Statement, Type};

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let step = std::mem::take(&mut program.step);
    program.step = in_list(step, &mut Facts::default(), &mut Conditions::of(&program), &program);
    Ok(program)
}

fn in_list(
    list: Vec<Statement>,
    facts: &mut Facts,
    conditions: &mut Conditions<'_>,
    program: &Program,
) -> Vec<Statement> {
    let mut kept = Vec::with_capacity(list.len());
    for statement in list {
        match statement {
            Statement::Note(text) => kept.push(Statement::Note(text)),
            Statement::Assign { target, mut value } => {
                let meant = (program.ty(target) == Some(Type::Bool)).then(|| simplify(&mut value, facts, conditions));
                facts.assign(conditions, target, &value);
                meant.into_iter().for_each(|meant| facts.mean(conditions, target, meant));
                kept.push(Statement::Assign { target, value });
            }
            Statement::If { mut condition, then, otherwise } => {
                let id = simplify(&mut condition, facts, conditions);
                if let Condition::Known(holds) = conditions.all[id] {
                    kept.extend(in_list(if holds { then } else { otherwise }, facts, conditions, program));
                    continue;
                }
                let mut no = facts.clone();
                facts.learn(conditions, id, true);
                no.learn(conditions, id, false);
                let then = in_list(then, facts, conditions, program);
                let otherwise = in_list(otherwise, &mut no, conditions, program);
                facts.join(&no);
                kept.push(Statement::If { condition, then, otherwise });
            }
            Statement::Choose { .. } | Statement::Apart(_) => panic!("known: nothing has been legalised yet"),
        }
    }
    kept
}

/// Removes known parts from a condition; returns its number.
fn simplify(condition: &mut Expr, facts: &mut Facts, conditions: &mut Conditions<'_>) -> Id {
    let before = conditions.number(condition);
    let after = facts.simplify(conditions, before);
    if after != before {
        *condition = conditions.expr(after);
    }
    after
}
