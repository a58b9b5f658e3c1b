//! Removes copies left by joining two branches: `a` is computed, then `b := a`. Afterwards `b` is computed directly.

use super::Defect;
use crate::program::{Expr, Program, Statement, Var, rename};

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    let mut everywhere = vec![0; program.locals.len()];
    program.statements().for_each(|statement| locals(statement, &mut |local| everywhere[local] += 1));
    coalesce(&mut program.init, &mut everywhere);
    coalesce(&mut program.step, &mut everywhere);
    Ok(program)
}

/// Coalesces a list of statements, inner lists last: a copy after a branch can become one inside it. `everywhere`: how often
/// each local is mentioned.
fn coalesce(list: &mut Vec<Statement>, everywhere: &mut [usize]) {
    if list.iter().any(|statement| copy(statement).is_some()) {
        coalesce_here(list, everywhere);
    }
    list.iter_mut().for_each(|statement| statement.change_branches(|inner| coalesce(inner, everywhere)));
}

/// Removes each copy from a local that is used only in this list to a local that is not mentioned before it in this list: the
/// target can take the value as soon as it is computed.
fn coalesce_here(list: &mut Vec<Statement>, everywhere: &mut [usize]) {
    let (mut here, mut first) = (vec![0; everywhere.len()], vec![usize::MAX; everywhere.len()]);
    for (position, statement) in list.iter().enumerate() {
        locals(statement, &mut |local| {
            here[local] += 1;
            first[local] = first[local].min(position);
        });
    }
    let mut name: Vec<usize> = (0..everywhere.len()).collect();
    let mut position = 0;
    list.retain(|statement| {
        let at = position;
        position += 1;
        let Some((from, to)) = copy(statement).map(|(from, to)| (name[from], name[to])) else { return true };
        if here[from] != everywhere[from] || first[to] != at {
            return true;
        }
        for mentions in [&mut *everywhere, &mut here] {
            mentions[to] += mentions[from] - 2; // the copy mentioned each of them once
            mentions[from] = 0;
        }
        first[to] = first[from];
        name.iter_mut().filter(|name| **name == from).for_each(|name| *name = to);
        false
    });
    if list.len() < position {
        rename(list, &|var| if let Var::Local(local) = var { Var::Local(name[local]) } else { var });
    }
}

/// Calls `visit` for each time that a statement mentions a local.
fn locals(statement: &Statement, visit: &mut impl FnMut(usize)) {
    statement.variables(&mut |var| {
        if let Var::Local(local) = var {
            visit(local);
        }
    });
}

/// Source and target of a statement that copies a local.
fn copy(statement: &Statement) -> Option<(usize, usize)> {
    match statement {
        Statement::Assign { target: Var::Local(to), value: Expr::Var(Var::Local(from)) } => Some((*from, *to)),
        _ => None,
    }
}
