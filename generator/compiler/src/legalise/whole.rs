//! Makes `init` assign every part of the state, so that a memory checker finds no uninitialised memory.

use crate::pass::Defect;
use crate::program::{Expr, Program, Statement, Var};

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let is_given = |target| {
        let assigns =
            |statement: &Statement| matches!(statement, Statement::Assign { target: to, .. } if *to == target);
        program.init.iter().any(assigns)
    };
    let starts = program.state.iter().enumerate().map(|(index, variable)| (Var::State(index), variable.start));
    let missing = starts.filter(|(target, _)| !is_given(*target));
    let mut init: Vec<Statement> =
        missing.map(|(target, start)| Statement::Assign { target, value: Expr::Literal(start) }).collect();
    init.append(&mut program.init);
    // Plain values, in the order of the declarations.
    if let Some(places) = init.iter().map(place).collect::<Option<Vec<usize>>>()
        && places.len() == program.state.len()
    {
        init.sort_by_key(place);
    }
    program.init = init;
    Ok(program)
}

/// The part of the state that gets a constant value.
fn place(statement: &Statement) -> Option<usize> {
    match statement {
        Statement::Assign { target: Var::State(index), value: Expr::Literal(_) | Expr::Var(Var::Constant(_)) } => {
            Some(*index)
        }
        _ => None,
    }
}
