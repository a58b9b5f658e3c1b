//! Moves the assignments of `init` into the first cycle, except those of 0 and FALSE: every target clears the memory of an
//! instance, but not every one applies initial values.

use crate::pass::Defect;
use crate::program::{Constant, Expr, Program, Statement, Type, Var, Variable};
use portable::Literal;

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let mut init = std::mem::take(&mut program.init);
    init.retain(|statement| !is_clear(statement, &program.constants, &program.state));
    if init.is_empty() {
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

/// Whether a statement assigns the 0 or FALSE that a part of the state already has.
fn is_clear(statement: &Statement, constants: &[Constant], state: &[Variable]) -> bool {
    match statement {
        Statement::Note(_) => true,
        Statement::Assign { target: Var::State(part), value } => {
            let value = value.known(constants);
            value.is_some_and(is_cleared) && is_cleared(state[*part].start)
        }
        _ => false,
    }
}

/// Whether cleared memory is this value: 0, not -0.
fn is_cleared(value: Literal) -> bool {
    match value {
        Literal::Bool(value) => !value,
        Literal::I32(value) => value == 0,
        Literal::U32(value) => value == 0,
        Literal::F64(value) => value.to_bits() == 0,
        Literal::F32(value) => value.to_bits() == 0,
        Literal::Usize(_) | Literal::Variant(_) => false,
    }
}
