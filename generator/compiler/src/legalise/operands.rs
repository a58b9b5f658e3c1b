//! Names every real number that is an operand: its digits would be LREAL, and make a whole REAL expression LREAL.

use crate::pass::Defect;
use crate::program::{Constant, Expr, Origin, Program, Var, map_expressions};
use portable::{Literal, RealKind};

/// The program with its numbers among the constants; a number that is assigned alone stays.
pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let first = program.constants.len();
    let constants = &mut program.constants;
    let mut name = |part: &mut Expr| {
        if let Expr::Literal(value @ (Literal::F64(_) | Literal::F32(_))) = *part {
            let known = constants[first..].iter().position(|constant| constant.value == value);
            let number = known.unwrap_or_else(|| {
                let path = name_of(value);
                constants.push(Constant { path, doc: "constant of the algorithm", value, origin: Origin::Function });
                constants.len() - 1 - first
            });
            *part = Expr::Var(Var::Constant(first + number));
        }
    };
    map_expressions(&mut program.step, &mut |expr| {
        if !matches!(expr, Expr::Literal(_)) {
            expr.change(&mut name);
        }
    });
    Ok(program)
}

/// Names only the operands in single precision: the digits of an LREAL may be combined with an LREAL.
pub(super) fn run_single(program: Program) -> Result<Program, Defect> {
    if program.real == RealKind::F32 { run(program) } else { Ok(program) }
}

/// The name of a number: `zero`, `one`, else its digits, as in `number_0p5`.
fn name_of(value: Literal) -> String {
    let digits = match value {
        Literal::F64(value) => format!("{value:?}"),
        Literal::F32(value) => format!("{value:?}"),
        other => panic!("operands: {other:?} is not a real"),
    };
    match digits.as_str() {
        "0.0" => "zero".to_owned(),
        "1.0" => "one".to_owned(),
        digits => format!("number_{}", digits.trim_end_matches(".0").replace('.', "p").replace('-', "m")),
    }
}
