//! Answers the conditions that have one answer only, whatever state, inputs and sets contain. The passes then leave out what
//! cannot be reached.

use crate::pass::{self, Defect};
use crate::program::{Expr, Program, Statement};

/// The program without the branches that are never taken. `decided` is that of [`super::Shown`].
///
/// # Errors
/// The first defect.
pub fn run(mut program: Program, decided: &[(usize, bool)]) -> Result<Program, Defect> {
    if decided.is_empty() {
        return Ok(program);
    }
    in_list(&mut program.step, decided, &mut 0);
    pass::run(program, None)
}

fn in_list(list: &mut [Statement], decided: &[(usize, bool)], choices: &mut usize) {
    for statement in list {
        if let Statement::If { condition, .. } = statement {
            if let Some((_, answer)) = decided.iter().find(|(choice, _)| choice == choices) {
                *condition = Expr::bool(*answer);
            }
            *choices += 1;
        }
        statement.change_branches(|list| in_list(list, decided, choices));
    }
}
