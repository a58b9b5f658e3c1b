//! Removes the copies that joining two branches leaves: `a` is computed, then `b := a`. Afterwards `b` is computed.

use super::Defect;
use crate::program::{Expr, Program, Statement, Var, rename};

/// Runs the pass.
///
/// # Errors
/// None.
pub fn run(mut program: Program) -> Result<Program, Defect> {
    let mut everywhere = vec![0; program.locals.len()];
    count(&program.init, &mut everywhere);
    count(&program.step, &mut everywhere);
    coalesce(&mut program.init, &mut everywhere);
    coalesce(&mut program.step, &mut everywhere);
    Ok(program)
}

/// Coalesces a list of statements, inner lists last: a copy that leaves a branch becomes one inside it.
fn coalesce(list: &mut Vec<Statement>, everywhere: &mut Vec<usize>) {
    while let Some((copy, from, to)) = find(list, everywhere) {
        list.remove(copy);
        everywhere[to] += everywhere[from] - 2; // the copy mentioned each of them once
        everywhere[from] = 0;
        let (from, to) = (Var::Local(from), Var::Local(to));
        rename(list, &|var| if var == from { to } else { var });
    }
    for statement in list {
        if let Statement::If { then, otherwise, .. } = statement {
            coalesce(then, everywhere);
            coalesce(otherwise, everywhere);
        }
    }
}

/// A copy from a local that lives in this list alone to a local that nothing before it in this list mentions: the target
/// can take the value as soon as it exists.
fn find(statements: &[Statement], everywhere: &[usize]) -> Option<(usize, usize, usize)> {
    let copies = statements.iter().enumerate().filter_map(|(position, statement)| match statement {
        Statement::Assign { target: Var::Local(to), value: Expr::Var(Var::Local(from)) } => {
            Some((position, *from, *to))
        }
        _ => None,
    });
    let mut here = None;
    for (position, from, to) in copies {
        let here = here.get_or_insert_with(|| {
            let mut here = vec![0; everywhere.len()];
            count(statements, &mut here);
            here
        });
        let mentioned = statements[..position].iter().any(|earlier| earlier.mentions(Var::Local(to)));
        if here[from] == everywhere[from] && !mentioned {
            return Some((position, from, to));
        }
    }
    None
}

/// Counts how often each local is mentioned.
fn count(list: &[Statement], mentions: &mut [usize]) {
    for statement in list {
        statement.variables(&mut |var| {
            if let Var::Local(local) = var {
                mentions[local] += 1;
            }
        });
    }
}
