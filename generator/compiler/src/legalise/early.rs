//! Moves an assignment of a value that is already known before the branches that do not affect it. Compilers then need not keep
//! the value, nor join the branches for it.
//!
//! ```text
//! if a { .. } else { .. }          x_drive := x_command
//! x_drive := x_command        ->   if a { .. } else { .. }
//! ```

use crate::pass::Defect;
use crate::program::{Expr, Program, Statement, Var};

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    in_list(&mut program.step);
    Ok(program)
}

fn in_list(list: &mut Vec<Statement>) {
    for at in 0..list.len() {
        if let Some(place) = place(&list[..at], &list[at]) {
            let statement = list.remove(at);
            list.insert(place, statement);
        }
    }
    list.iter_mut().for_each(|statement| statement.change_branches(in_list));
}

/// The earliest place to which a statement may move; `None` if it must stay.
fn place(before: &[Statement], statement: &Statement) -> Option<usize> {
    let Statement::Assign { target: target @ (Var::Output(_) | Var::State(_)), value } = statement else { return None };
    let known = match value {
        Expr::Literal(_) => None,
        Expr::Var(var @ (Var::Input(_) | Var::Constant(_) | Var::Local(_))) => Some(*var),
        _ => return None,
    };
    let is_bound = |before: &Statement| before.mentions(*target) || known.is_some_and(|var| before.writes(var));
    let place = before.iter().rposition(is_bound).map_or(0, |last| last + 1);
    let crosses_a_branch = before[place..].iter().any(|between| matches!(between, Statement::If { .. }));
    crosses_a_branch.then_some(place)
}
