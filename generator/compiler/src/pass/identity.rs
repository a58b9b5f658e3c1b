//! Removes multiplications whose result is known or is the other operand: by 1, by -1, and of 0 with a named number.
//!
//! All are exact for every number. `x + 0` and `x * 0` of a value that is not known stay: they change a -0.

use super::Defect;
use crate::arithmetic;
use crate::program::{Constant, Expr, Program, Var, map_expressions};
use portable::{Binary, Literal, Unary};

/// Runs the pass.
///
/// # Errors
/// None.
pub fn run(mut program: Program) -> Result<Program, Defect> {
    let constants = &program.constants;
    let mut change = |expr: Expr| expr.map(&mut |part| simplify(part, constants));
    program.init = map_expressions(program.init, &mut change);
    program.step = map_expressions(program.step, &mut change);
    Ok(program)
}

fn simplify(expr: Expr, constants: &[Constant]) -> Expr {
    let Expr::Binary(Binary::Multiply, left, right) = expr else { return expr };
    let (a, b) = (known(&left, constants), known(&right, constants));
    match (a, b) {
        (Some(a), Some(b)) if is_zero(a) || is_zero(b) => Expr::Literal(arithmetic::binary(Binary::Multiply, a, b)),
        (Some(a), _) if is_one(a) => *right,
        (_, Some(b)) if is_one(b) => *left,
        (Some(a), _) if is_minus_one(a) => Expr::Unary(Unary::Negate, right),
        (_, Some(b)) if is_minus_one(b) => Expr::Unary(Unary::Negate, left),
        _ => Expr::Binary(Binary::Multiply, left, right),
    }
}

/// The value of a real literal or of a named real number.
fn known(expr: &Expr, constants: &[Constant]) -> Option<Literal> {
    let value = match expr {
        Expr::Literal(literal) => *literal,
        Expr::Var(Var::Constant(index)) => constants[*index].value,
        _ => return None,
    };
    matches!(value, Literal::F64(_) | Literal::F32(_)).then_some(value)
}

fn is_zero(value: Literal) -> bool {
    let zeros = [Literal::F64(0.0), Literal::F64(-0.0), Literal::F32(0.0), Literal::F32(-0.0)];
    zeros.contains(&value)
}

fn is_one(value: Literal) -> bool {
    value == Literal::F64(1.0) || value == Literal::F32(1.0)
}

fn is_minus_one(value: Literal) -> bool {
    value == Literal::F64(-1.0) || value == Literal::F32(-1.0)
}
