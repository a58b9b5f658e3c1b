//! Removes assignments of locals that are not read afterwards: joining two branches leaves them if only one branch uses the
//! value.

use super::Defect;
use crate::program::{Program, Statement, Table, Var};

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    let nothing = Table::filled(&program, false);
    live(&mut program.init, &mut nothing.clone());
    live(&mut program.step, &mut nothing.clone());
    Ok(program)
}

/// Keeps the assignments of a list that are read later. `read`: the variables read after the list; on return, those read before
/// it.
fn live(list: &mut Vec<Statement>, read: &mut Table<bool>) {
    let mut kept: Vec<Statement> = std::mem::take(list).into_iter().rev().filter_map(|it| keep(it, read)).collect();
    kept.reverse();
    *list = kept;
}

fn keep(mut statement: Statement, read: &mut Table<bool>) -> Option<Statement> {
    match &mut statement {
        Statement::Note(_) => {}
        Statement::Assign { target, value } => {
            if matches!(target, Var::Local(_)) && !std::mem::take(&mut read[*target]) {
                return None;
            }
            value.variables(&mut |var| read[var] = true);
        }
        Statement::If { condition, then, otherwise } => {
            let mut other = read.clone();
            live(then, read);
            live(otherwise, &mut other);
            if then.is_empty() && otherwise.is_empty() {
                return None;
            }
            read.locals.iter_mut().zip(other.locals).for_each(|(read, other)| *read |= other);
            condition.variables(&mut |var| read[var] = true);
        }
        Statement::Choose { .. } | Statement::Apart(_) => panic!("live: nothing has been legalised yet"),
    }
    Some(statement)
}
