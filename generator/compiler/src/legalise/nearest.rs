//! Expands the rounding to the nearest integer: the conversions of the standard round differently, but all implementations
//! truncate in the same way.
//!
//! ```text
//! n := nearest(x);   ->   IF x >= 0.0 THEN n := TRUNC(x + 0.49999999999999994); ELSE n := TRUNC(x - 0.49999999999999994); END_IF;
//! ```

use crate::pass::Defect;
use crate::program::{Constant, Expr, Origin, Program, Statement, Var, retain_mut};
use portable::{Binary, Intrinsic, Literal, RealKind};

/// The program without that operation; the printer rejects one inside another expression.
pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let (real, half) = (program.real, Var::Constant(program.constants.len()));
    let mut is_used = false;
    retain_mut(&mut program.step, &mut |statement| {
        if let Statement::Assign { target, value: Expr::Intrinsic(Intrinsic::Nearest, operands) } = statement {
            is_used = true;
            *statement = spelled_out(*target, operands.remove(0), real, half);
        }
        true
    });
    if is_used {
        program.constants.push(Constant {
            path: "nearly_half".to_owned(),
            doc: "largest number below 1/2, added before truncation in order to round",
            value: nearly_half(real),
            origin: Origin::Function,
        });
    }
    Ok(program)
}

/// The largest number below 1/2.
pub fn nearly_half(real: RealKind) -> Literal {
    match real {
        RealKind::F64 => Literal::F64(portable::nearly_half()),
        RealKind::F32 => Literal::F32(portable::nearly_half()),
    }
}

fn spelled_out(target: Var, x: Expr, real: RealKind, half: Var) -> Statement {
    let zero = match real {
        RealKind::F64 => Literal::F64(0.0),
        RealKind::F32 => Literal::F32(0.0),
    };
    let truncated = |operator| {
        let value = Expr::Intrinsic(Intrinsic::Truncate, vec![Expr::binary(operator, x.clone(), Expr::Var(half))]);
        vec![Statement::Assign { target, value }]
    };
    Statement::If {
        condition: Expr::binary(Binary::GreaterEqual, x.clone(), Expr::Literal(zero)),
        then: truncated(Binary::Add),
        otherwise: truncated(Binary::Subtract),
    }
}
