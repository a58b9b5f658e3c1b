//! Avoids a sign before a 0, which some compilers read as a subtraction from 0.
//!
//! ```text
//! |x| <= 0   ->   x = 0.0          y := -0.0   ->   y := -1.0 * 0.0
//! ```

use crate::pass::Defect;
use crate::program::{Constant, Expr, Program, map_expressions};
use portable::{Binary, Intrinsic, Literal, Unary};

/// For languages in which a function checks a sample.
pub(super) fn run(program: Program) -> Result<Program, Defect> {
    Ok(change(program, &[Intrinsic::Within]))
}

/// For languages in which a sample is compared.
pub(super) fn run_digits(program: Program) -> Result<Program, Defect> {
    Ok(change(program, &[Intrinsic::Within, Intrinsic::InRange]))
}

fn change(mut program: Program, compared: &[Intrinsic]) -> Program {
    let constants = &program.constants;
    map_expressions(&mut program.step, &mut |expr| expr.change(&mut |part| without_sign(part, constants, compared)));
    program
}

fn without_sign(part: &mut Expr, constants: &[Constant], compared: &[Intrinsic]) {
    match part {
        Expr::Intrinsic(intrinsic, operands) if compared.contains(intrinsic) && operands[1].is_zero(constants) => {
            *part = Expr::binary(Binary::Equal, operands[0].clone(), operands[1].clone());
        }
        Expr::Unary(Unary::Negate, operand) if operand.is_zero(constants) => {
            *part = Expr::Literal(match operand.known(constants) {
                Some(Literal::F32(value)) => Literal::F32(-value),
                Some(Literal::F64(value)) => Literal::F64(-value),
                other => panic!("bound: {other:?} is not 0.0"),
            });
        }
        _ => {}
    }
}
