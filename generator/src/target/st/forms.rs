//! How each number with a name appears in a block, by what the block does with it.

use super::dialect::{Dialect, Form};
use compiler::program::{Expr, Program, Statement, Var};
use portable::Literal;

/// A form for each constant of a program.
#[must_use]
pub fn of(program: &Program, dialect: &Dialect) -> Vec<Form> {
    let mut forms: Vec<Form> = program.constants.iter().map(|constant| dialect.form(constant.value)).collect();
    if !dialect.declares_constants {
        let mut look = |expr: &Expr| expr.parts(&mut |part| assign_alone(part, program, &mut forms));
        program.step.iter().for_each(|statement: &Statement| statement.expressions(&mut look));
    }
    forms
}

/// Digits have no type of their own: an operator or a conversion that has nothing but integer digits would be anything.
fn assign_alone(expr: &Expr, program: &Program, forms: &mut [Form]) {
    let operands: Vec<&Expr> = match expr {
        Expr::Unary(_, operand) => vec![operand],
        Expr::Binary(_, left, right) => vec![left, right],
        Expr::Intrinsic(_, operands) => operands.iter().collect(),
        Expr::Literal(_) | Expr::Var(_) => return,
    };
    let is_integer = |value: Literal| matches!(value, Literal::I32(_) | Literal::U32(_));
    let is_digits = |operand: &&Expr| match operand {
        Expr::Literal(value) => is_integer(*value),
        Expr::Var(Var::Constant(index)) => is_integer(program.constants[*index].value),
        _ => false,
    };
    if operands.iter().all(is_digits) {
        for operand in operands {
            if let Expr::Var(Var::Constant(index)) = operand {
                forms[*index] = Form::Assigned;
            }
        }
    }
}
