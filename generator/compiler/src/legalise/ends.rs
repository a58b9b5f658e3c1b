//! Compares a number from 0 on with the ends of its range, instead of its magnitude: two operations less.
//!
//! ```text
//! in_range(x, limit) and x >= 0   ->   x >= 0 and x <= limit
//! ```
//!
//! For languages whose comparison with a NaN is false.

use crate::pass::Defect;
use crate::program::{Expr, Program, map_expressions};
use portable::{Binary, Intrinsic, Literal};

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    map_expressions(&mut program.step, &mut |expr| expr.change(&mut in_conjunction));
    Ok(program)
}

/// Conditions are joined from left to right: the one before `x >= 0` is alone, or the last one of those before.
fn in_conjunction(part: &mut Expr) {
    let Expr::Binary(Binary::And, before, last) = part else { return };
    let Expr::Binary(Binary::GreaterEqual, x, least) = &**last else { return };
    let range = match &mut **before {
        Expr::Binary(Binary::And, _, range) => &mut **range,
        range => range,
    };
    if matches!(**least, Expr::Literal(Literal::F64(0.0) | Literal::F32(0.0)))
        && let Expr::Intrinsic(Intrinsic::InRange | Intrinsic::Within, operands) = range
        && operands[0] == **x
    {
        let limit = operands[1].clone();
        let up_to = Expr::binary(Binary::LessEqual, (**x).clone(), limit);
        *range = std::mem::replace(&mut **last, up_to);
    }
}
