//! Moves the assignments of `init` into the first cycle: every target clears the memory of an instance to 0 and FALSE, but not
//! every one applies initial values. An `init` that assigns only 0 and FALSE is dropped.

use crate::pass::Defect;
use crate::program::{Expr, Program, Statement, Type, Var, Variable};
use portable::Literal;

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let mut init = std::mem::take(&mut program.init);
    if init.iter().all(is_clear) {
        return Ok(program);
    }
    let started = Var::State(program.state.len());
    program.state.push(Variable {
        path: "started".to_owned(),
        doc: "TRUE from the first cycle on",
        ty: Type::Bool,
        start: Literal::Bool(false),
    });
    init.push(Statement::Assign { target: started, value: Expr::bool(true) });
    let condition = Expr::not(Expr::Var(started));
    program.step.insert(0, Statement::If { condition, then: init, otherwise: Vec::new() });
    Ok(program)
}

/// Whether a statement assigns the value that a variable already has.
fn is_clear(statement: &Statement) -> bool {
    match statement {
        Statement::Note(_) => true,
        Statement::Assign { value: Expr::Literal(value), .. } => {
            use Literal::{Bool, F32, F64, I32, U32};
            [Bool(false), I32(0), U32(0), F64(0.0), F32(0.0)].contains(value)
        }
        _ => false,
    }
}
