//! Removes assignments of locals that nothing reads afterwards: what the joining of two branches leaves where only one of
//! them goes on.

use super::Defect;
use crate::program::{Expr, Program, Statement, Var};

/// Runs the pass.
///
/// # Errors
/// None.
pub fn run(mut program: Program) -> Result<Program, Defect> {
    let nothing = vec![false; program.locals.len()];
    live(&mut program.init, &mut nothing.clone());
    live(&mut program.step, &mut nothing.clone());
    Ok(program)
}

/// Keeps what of a list is read afterwards; `read` are the locals that are read behind it, then those before it.
fn live(list: &mut Vec<Statement>, read: &mut [bool]) {
    let mut kept: Vec<Statement> = std::mem::take(list).into_iter().rev().filter_map(|it| keep(it, read)).collect();
    kept.reverse();
    *list = kept;
}

fn keep(mut statement: Statement, read: &mut [bool]) -> Option<Statement> {
    match &mut statement {
        Statement::Note(_) => {}
        Statement::Assign { target, value } => {
            if let Var::Local(local) = *target
                && !std::mem::take(&mut read[local])
            {
                return None;
            }
            note_reads(value, read);
        }
        Statement::If { condition, then, otherwise } => {
            let mut other = read.to_vec();
            live(then, read);
            live(otherwise, &mut other);
            if then.is_empty() && otherwise.is_empty() {
                return None;
            }
            read.iter_mut().zip(other).for_each(|(read, other)| *read |= other);
            note_reads(condition, read);
        }
    }
    Some(statement)
}

fn note_reads(expr: &Expr, read: &mut [bool]) {
    expr.variables(&mut |var| {
        if let Var::Local(local) = var {
            read[local] = true;
        }
    });
}
