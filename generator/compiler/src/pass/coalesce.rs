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
    program.init = coalesce(program.init, &mut everywhere);
    program.step = coalesce(program.step, &mut everywhere);
    Ok(program)
}

/// Coalesces a list of statements, inner lists last: a copy that leaves a branch becomes one inside it.
fn coalesce(mut statements: Vec<Statement>, everywhere: &mut Vec<usize>) -> Vec<Statement> {
    while let Some((copy, from, to)) = find(&statements, everywhere) {
        statements.remove(copy);
        everywhere[to] += everywhere[from] - 2; // the copy mentioned each of them once
        everywhere[from] = 0;
        let (from, to) = (Var::Local(from), Var::Local(to));
        statements = rename(statements, &|var| if var == from { to } else { var });
    }
    statements
        .into_iter()
        .map(|statement| match statement {
            Statement::If { condition, then, otherwise } => Statement::If {
                condition,
                then: coalesce(then, everywhere),
                otherwise: coalesce(otherwise, everywhere),
            },
            other => other,
        })
        .collect()
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
fn count(statements: &[Statement], mentions: &mut [usize]) {
    let mut add = |var| {
        if let Var::Local(local) = var {
            mentions[local] += 1;
        }
    };
    for statement in statements {
        statement.targets(&mut add);
        statement.expressions(&mut |expr| expr.variables(&mut add));
    }
}
