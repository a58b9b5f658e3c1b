//! Leaves out an assignment that gives a variable the value that it has: branches that were joined, and variables that are
//! shared, leave such assignments.
//!
//! ```text
//! x := 0; if a { x := 0; y := x } else { y := 1 }   ->   x := 0; if a { y := x } else { y := 1 }
//! ```

use crate::pass::Defect;
use crate::program::{Expr, Program, Statement, Var};

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    in_list(&mut program.step, &mut Vec::new());
    Ok(program)
}

/// `known`: variables with the expressions that they have, before the list and then after it.
fn in_list(list: &mut Vec<Statement>, known: &mut Vec<(Var, Expr)>) {
    let mut statements = list.iter().filter(|statement| !matches!(statement, Statement::Note(_))).count();
    list.retain_mut(|statement| {
        if let Statement::Assign { target, value } = statement {
            // A branch keeps a statement.
            if statements > 1 && known.iter().any(|(var, has)| var == target && has == value) {
                statements -= 1;
                return false;
            }
            forget(known, *target);
            if !value.mentions(*target) {
                known.push((*target, value.clone()));
            }
            return true;
        }
        statement.change_branches(|branch| in_list(branch, &mut known.clone()));
        statement.assignments(&mut |target, _| forget(known, target));
        true
    });
}

/// Removes what an assignment to the variable changes.
fn forget(known: &mut Vec<(Var, Expr)>, changed: Var) {
    known.retain(|(var, has)| *var != changed && !has.mentions(changed));
}
