//! Gives every real number that is an operand a name: its digits would be LREAL, and make a whole REAL expression LREAL.

use crate::pass::Defect;
use crate::program::{Constant, Expr, Origin, Program, Var, map_expressions};
use portable::{Literal, RealKind};

/// The program with its numbers among the constants; one that is assigned as it is stays where it is.
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

/// Names the operands in single precision only: the digits of an LREAL may stand next to an LREAL.
pub(super) fn run_single(program: Program) -> Result<Program, Defect> {
    if program.real == RealKind::F32 { run(program) } else { Ok(program) }
}

/// What a number is called: `zero`, `one`, else its digits, as in `number_0p5`.
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
