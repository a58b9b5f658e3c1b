//! Leaves out an assignment that gives a variable the value that it has: branches that were joined, and variables that are
//! shared, leave such assignments.
//!
//! ```text
//! x := 0; if a { x := 0; y := x } else { y := 1 }   ->   x := 0; if a { y := x } else { y := 1 }
//! ```

use crate::pass::Defect;
use crate::program::{Expr, Program, Statement, Var};

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let again = assigned_again(&program.step);
    if !again.is_empty() {
        in_list(&mut program.step, &mut Vec::new(), &again);
    }
    Ok(program)
}

/// Variables and expressions that more than one statement assigns to them.
fn assigned_again(list: &[Statement]) -> Vec<(Var, Expr)> {
    let (mut once, mut again) = (Vec::new(), Vec::new());
    for statement in list {
        statement.assignments(&mut |target, value| {
            if !once.contains(&(target, value)) {
                once.push((target, value));
            } else if !value.mentions(target) {
                again.push((target, value.clone()));
            }
        });
    }
    again
}

/// `known`: those assignments, by their places in `again`, whose variables have the values, before the list and then after it.
fn in_list(list: &mut Vec<Statement>, known: &mut Vec<usize>, again: &[(Var, Expr)]) {
    let mut statements = list.iter().filter(|statement| !matches!(statement, Statement::Note(_))).count();
    list.retain_mut(|statement| {
        if let Statement::Assign { target, value } = statement {
            let place = again.iter().position(|(var, has)| var == target && has == value);
            // A branch keeps a statement.
            if statements > 1 && place.is_some_and(|place| known.contains(&place)) {
                statements -= 1;
                return false;
            }
            forget(known, *target, again);
            known.extend(place);
            return true;
        }
        statement.change_branches(|branch| in_list(branch, &mut known.clone(), again));
        statement.assignments(&mut |target, _| forget(known, target, again));
        true
    });
}

/// Removes what an assignment to the variable changes.
fn forget(known: &mut Vec<usize>, changed: Var, again: &[(Var, Expr)]) {
    known.retain(|place| again[*place].0 != changed && !again[*place].1.mentions(changed));
}
