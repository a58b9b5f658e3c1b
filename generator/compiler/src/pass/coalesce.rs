//! Removes copies left by joining two branches: `a` is computed, then `b := a`. Afterwards `b` is computed directly.

use super::Defect;
use crate::program::{Expr, Program, Statement, Table, Var, rename};

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    let nothing = Table::filled(&program, 0);
    let mut everywhere = nothing.clone();
    program.statements().for_each(|statement| statement.variables(&mut |var| everywhere[var] += 1));
    coalesce(&mut program.init, &mut everywhere, &nothing);
    coalesce(&mut program.step, &mut everywhere, &nothing);
    Ok(program)
}

/// Coalesces a list of statements, inner lists last: a copy after a branch can become one inside it.
fn coalesce(list: &mut Vec<Statement>, everywhere: &mut Table<usize>, nothing: &Table<usize>) {
    if list.iter().any(|statement| copy(statement).is_some()) {
        let mut here = nothing.clone();
        list.iter().for_each(|statement| statement.variables(&mut |var| here[var] += 1));
        while let Some((position, from, to)) = find(list, everywhere, &here) {
            list.remove(position);
            for mentions in [&mut *everywhere, &mut here] {
                mentions[to] += mentions[from] - 2; // the copy mentioned each of them once
                mentions[from] = 0;
            }
            rename(list, &|var| if var == from { to } else { var });
        }
    }
    for list in list.iter_mut().flat_map(Statement::branches_mut) {
        coalesce(list, everywhere, nothing);
    }
}

/// A copy from a local that is used only in this list to a local that is not mentioned before it in this list: the target
/// can take the value as soon as it is computed.
fn find(list: &[Statement], everywhere: &Table<usize>, here: &Table<usize>) -> Option<(usize, Var, Var)> {
    list.iter().enumerate().find_map(|(position, statement)| {
        let (from, to) = copy(statement)?;
        let is_target_free = || !list[..position].iter().any(|earlier| earlier.mentions(to));
        (here[from] == everywhere[from] && is_target_free()).then_some((position, from, to))
    })
}

/// Source and target of a statement that copies a local.
fn copy(statement: &Statement) -> Option<(Var, Var)> {
    match statement {
        Statement::Assign { target: to @ Var::Local(_), value: Expr::Var(from @ Var::Local(_)) } => Some((*from, *to)),
        _ => None,
    }
}
