//! Removes assignments of locals that nothing reads afterwards: what the joining of two branches leaves where only one of
//! them goes on.

use super::Defect;
use crate::program::{Expr, Program, Statement, Var};
use std::collections::BTreeSet;

/// Runs the pass.
///
/// # Errors
/// None.
pub fn run(mut program: Program) -> Result<Program, Defect> {
    program.init = live(program.init, &mut BTreeSet::new());
    program.step = live(program.step, &mut BTreeSet::new());
    Ok(program)
}

/// What of a list is read afterwards; `read` are the locals that are read behind it, then those before it.
fn live(list: Vec<Statement>, read: &mut BTreeSet<usize>) -> Vec<Statement> {
    let mut kept: Vec<Statement> = list.into_iter().rev().filter_map(|statement| keep(statement, read)).collect();
    kept.reverse();
    kept
}

fn keep(statement: Statement, read: &mut BTreeSet<usize>) -> Option<Statement> {
    match statement {
        Statement::Note(text) => Some(Statement::Note(text)),
        Statement::Assign { target, value } => {
            if let Var::Local(local) = target
                && !read.remove(&local)
            {
                return None;
            }
            note_reads(&value, read);
            Some(Statement::Assign { target, value })
        }
        Statement::If { condition, then, otherwise } => {
            let mut other = read.clone();
            let (then, otherwise) = (live(then, read), live(otherwise, &mut other));
            if then.is_empty() && otherwise.is_empty() {
                return None;
            }
            read.append(&mut other);
            note_reads(&condition, read);
            Some(Statement::If { condition, then, otherwise })
        }
    }
}

fn note_reads(expr: &Expr, read: &mut BTreeSet<usize>) {
    expr.variables(&mut |var| {
        if let Var::Local(local) = var {
            read.insert(local);
        }
    });
}
