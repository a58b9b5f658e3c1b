//! Spells out the rounding to the nearest integer: no conversion of the standard rounds alike everywhere, but all truncate
//! alike.
//!
//! ```text
//! n := nearest(x);   ->   IF x >= 0.0 THEN n := TRUNC(x + 0.49999999999999994); ELSE n := TRUNC(x - 0.49999999999999994); END_IF;
//! ```

use compiler::program::{Constant, Expr, Origin, Program, Statement, Var};
use portable::{Binary, Intrinsic, Literal, RealKind, nearly_half};

/// The program without that operation.
///
/// # Panics
/// If it stands inside another expression, which the portable subset does not have.
#[must_use]
pub fn run(mut program: Program) -> Program {
    let half = Var::Constant(program.constants.len());
    let mut is_used = false;
    program.step = in_list(std::mem::take(&mut program.step), program.real, half, &mut is_used);
    if is_used {
        program.constants.push(Constant {
            path: "nearly_half".to_owned(),
            doc: "the largest number below 1/2: what is added before a number is truncated, so that it is rounded",
            value: match program.real {
                RealKind::F64 => Literal::F64(nearly_half()),
                RealKind::F32 => Literal::F32(nearly_half()),
            },
            origin: Origin::Function,
        });
    }
    program
}

fn in_list(list: Vec<Statement>, real: RealKind, half: Var, is_used: &mut bool) -> Vec<Statement> {
    list.into_iter()
        .map(|statement| match statement {
            Statement::Assign { target, value: Expr::Intrinsic(Intrinsic::Nearest, operands) } => {
                *is_used = true;
                let [x] = <[Expr; 1]>::try_from(operands).expect("st: a number is rounded");
                spelled_out(target, x, real, half)
            }
            Statement::If { condition, then, otherwise } => Statement::If {
                condition,
                then: in_list(then, real, half, is_used),
                otherwise: in_list(otherwise, real, half, is_used),
            },
            other => other,
        })
        .collect()
}

fn spelled_out(target: Var, x: Expr, real: RealKind, half: Var) -> Statement {
    let zero = match real {
        RealKind::F64 => Literal::F64(0.0),
        RealKind::F32 => Literal::F32(0.0),
    };
    let both = |operator, left: Expr, right| Expr::Binary(operator, Box::new(left), Box::new(right));
    let truncated = |operator| {
        let value = Expr::Intrinsic(Intrinsic::Truncate, vec![both(operator, x.clone(), Expr::Var(half))]);
        vec![Statement::Assign { target, value }]
    };
    Statement::If {
        condition: both(Binary::GreaterEqual, x.clone(), Expr::Literal(zero)),
        then: truncated(Binary::Add),
        otherwise: truncated(Binary::Subtract),
    }
}
