//! Removes assignments of locals that are not read afterwards: joining two branches leaves them if only one branch uses the
//! value.

use super::Defect;
use crate::program::{Expr, Program, Statement, Var};

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    live(&mut program.init, &mut vec![false; program.locals.len()]);
    live(&mut program.step, &mut vec![false; program.locals.len()]);
    Ok(program)
}

/// Keeps the assignments of a list that are read later. `read`: the locals read after the list; on return, those read before
/// it.
fn live(list: &mut Vec<Statement>, read: &mut Vec<bool>) {
    let mut kept: Vec<Statement> = std::mem::take(list).into_iter().rev().filter_map(|it| keep(it, read)).collect();
    kept.reverse();
    *list = kept;
}

fn keep(mut statement: Statement, read: &mut Vec<bool>) -> Option<Statement> {
    match &mut statement {
        Statement::Note(_) => {}
        Statement::Assign { target, value } => {
            if let Var::Local(local) = target
                && !std::mem::take(&mut read[*local])
            {
                return None;
            }
            mark(value, read);
        }
        Statement::If { condition, then, otherwise } => {
            let mut other = read.clone();
            live(then, read);
            live(otherwise, &mut other);
            if then.is_empty() && otherwise.is_empty() {
                return None;
            }
            read.iter_mut().zip(other).for_each(|(read, other)| *read |= other);
            mark(condition, read);
        }
        Statement::Choose { .. } | Statement::Apart(_) => panic!("live: nothing has been legalised yet"),
    }
    Some(statement)
}

/// Marks the locals that an expression reads.
fn mark(expr: &Expr, read: &mut [bool]) {
    expr.variables(&mut |var| {
        if let Var::Local(local) = var {
            read[local] = true;
        }
    });
}
