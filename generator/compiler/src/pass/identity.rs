//! Removes multiplications whose result is known or is the other operand: by 1, by -1, and of 0 with a named number.
//!
//! All replacements are exact for every number. `x + 0` and `x * 0` of an unknown value stay, because they change a -0.

use super::Defect;
use crate::arithmetic::{self, wide};
use crate::program::{Constant, Expr, Program, map_expressions};
use portable::{Binary, Literal, Unary};

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    let constants = &program.constants;
    let mut simplify = |expr: &mut Expr| expr.change(&mut |part| simplify(part, constants));
    map_expressions(&mut program.init, &mut simplify);
    map_expressions(&mut program.step, &mut simplify);
    Ok(program)
}

fn simplify(expr: &mut Expr, constants: &[Constant]) {
    let Expr::Binary(Binary::Multiply, left, right) = expr else { return };
    let take = |operand: &mut Expr| std::mem::replace(operand, Expr::bool(false));
    let negated = |operand| Expr::Unary(Unary::Negate, Box::new(operand));
    let values = [left.known(constants), right.known(constants)];
    let [is_0, is_1, is_minus_1] = [0.0, 1.0, -1.0].map(|number| values.map(|value| is(value, number)));
    *expr = match values {
        [Some(a), Some(b)] if is_0 != [false; 2] => Expr::Literal(arithmetic::binary(Binary::Multiply, a, b)),
        _ if is_1[0] => take(right),
        _ if is_1[1] => take(left),
        _ if is_minus_1[0] => negated(take(right)),
        _ if is_minus_1[1] => negated(take(left)),
        _ => return,
    };
}

fn is(value: Option<Literal>, number: f64) -> bool {
    value.and_then(wide) == Some(number)
}
