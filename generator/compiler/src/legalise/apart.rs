//! Separates the rare path: the last `else` of a block that begins with the fast path. In C it becomes a separate function,
//! called last, so that the fast path does not save registers.

use crate::pass::Defect;
use crate::program::{Program, Statement, Var};
use std::collections::BTreeSet;

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    if program.usual_first
        && let Some(rest) = last_else(&mut program.step)
        && stands_alone(rest)
    {
        *rest = vec![Statement::Apart(std::mem::take(rest))];
    }
    Ok(program)
}

/// The last `else` of the last chain of conditions.
pub(super) fn last_else(list: &mut [Statement]) -> Option<&mut Vec<Statement>> {
    let Some(Statement::If { otherwise, .. }) = list.last_mut() else { return None };
    let goes_on = matches!(otherwise[..], [Statement::If { .. }]);
    if goes_on { last_else(otherwise) } else { Some(otherwise).filter(|rest| !rest.is_empty()) }
}

/// Whether the statements read only their own locals.
fn stands_alone(list: &[Statement]) -> bool {
    let (mut read, mut written) = (BTreeSet::new(), BTreeSet::new());
    for statement in list {
        statement.assignments(&mut |target, _| {
            written.insert(target);
        });
        statement.reads(&mut |var| {
            read.insert(var);
        });
    }
    read.iter().all(|var| !matches!(var, Var::Local(_)) || written.contains(var))
}
