//! Removes the multiplications by 1 and -1, exact for every number. `x + 0` and `x * 0` stay: they change a -0.

use super::Defect;
use crate::program::{Constant, Expr, Program, Var, map_expressions};
use portable::{Binary, Literal, Unary};

/// Runs the pass.
///
/// # Errors
/// None.
pub fn run(mut program: Program) -> Result<Program, Defect> {
    let constants = &program.constants;
    program.step = map_expressions(program.step, &mut |expr| expr.map(&mut |part| simplify(part, constants)));
    Ok(program)
}

fn simplify(expr: Expr, constants: &[Constant]) -> Expr {
    let Expr::Binary(Binary::Multiply, left, right) = expr else { return expr };
    match (one(&left, constants), one(&right, constants)) {
        (Some(1), _) => *right,
        (_, Some(1)) => *left,
        (Some(_), _) => Expr::Unary(Unary::Negate, right),
        (_, Some(_)) => Expr::Unary(Unary::Negate, left),
        _ => Expr::Binary(Binary::Multiply, left, right),
    }
}

/// 1 or -1, if the expression is the real number 1 or -1.
fn one(expr: &Expr, constants: &[Constant]) -> Option<i8> {
    let literal = match expr {
        Expr::Literal(literal) => *literal,
        Expr::Var(Var::Constant(index)) => constants[*index].value,
        _ => return None,
    };
    match literal {
        literal if literal == Literal::F64(1.0) || literal == Literal::F32(1.0) => Some(1),
        literal if literal == Literal::F64(-1.0) || literal == Literal::F32(-1.0) => Some(-1),
        _ => None,
    }
}
