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
    let mut simplify = |expr: &mut Expr| expr.change(&mut |part| simplify(part, constants));
    map_expressions(&mut program.init, &mut simplify);
    map_expressions(&mut program.step, &mut simplify);
    Ok(program)
}

fn simplify(expr: &mut Expr, constants: &[Constant]) {
    let Expr::Binary(Binary::Multiply, left, right) = expr else { return };
    let take = |operand: &mut Expr| std::mem::replace(operand, Expr::Literal(Literal::Bool(false)));
    let negated = |operand| Expr::Unary(Unary::Negate, Box::new(operand));
    *expr = match (known(left, constants), known(right, constants)) {
        (Some(a), Some(b)) if is_zero(a) || is_zero(b) => Expr::Literal(arithmetic::binary(Binary::Multiply, a, b)),
        (Some(a), _) if is_one(a) => take(right),
        (_, Some(b)) if is_one(b) => take(left),
        (Some(a), _) if is_minus_one(a) => negated(take(right)),
        (_, Some(b)) if is_minus_one(b) => negated(take(left)),
        _ => return,
    };
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
