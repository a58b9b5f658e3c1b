//! Removes conditions whose value is known: from the branch that they stand in, from an assignment before, from an earlier
//! condition.
//!
//! ```text
//! if a || b { if a { x } else { if b { y } else { z } } }   ->   if a || b { if a { x } else { y } }
//! ```

use super::Defect;
use super::facts::Facts;
use crate::program::{Expr, Program, Statement, Type};
use portable::Literal;

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    let step = std::mem::take(&mut program.step);
    program.step = in_list(step, &mut Facts::none(&program.constants), &program);
    Ok(program)
}

fn in_list(list: Vec<Statement>, facts: &mut Facts, program: &Program) -> Vec<Statement> {
    let mut kept = Vec::new();
    for statement in list {
        match statement {
            Statement::Note(text) => kept.push(Statement::Note(text)),
            Statement::Assign { target, value } => {
                let value = if program.ty(target) == Some(Type::Bool) { facts.simplify(value) } else { value };
                facts.assign(target, &value);
                kept.push(Statement::Assign { target, value });
            }
            Statement::If { condition, then, otherwise } => match facts.simplify(condition) {
                Expr::Literal(Literal::Bool(holds)) => {
                    kept.extend(in_list(if holds { then } else { otherwise }, facts, program));
                }
                condition => {
                    let (mut yes, mut no) = (facts.clone(), facts.clone());
                    yes.learn(&condition, true);
                    no.learn(&condition, false);
                    let then = in_list(then, &mut yes, program);
                    let otherwise = in_list(otherwise, &mut no, program);
                    *facts = yes.join(&no);
                    kept.push(Statement::If { condition, then, otherwise });
                }
            },
        }
    }
    kept
}
