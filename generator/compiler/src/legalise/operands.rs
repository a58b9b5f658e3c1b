//! Names every real number that is an operand where its digits could have another type: next to a REAL they are LREAL, and
//! make the whole expression LREAL; in SCL they need not be LREAL.

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
                let doc = "its digits in a statement could have another type";
                constants.push(Constant { path: name_of(value), doc, value, origin: Origin::Function });
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

/// The name of a number with its type: `real_zero`, `lreal_one`, else its digits, as in `real_0p5`.
fn name_of(value: Literal) -> String {
    let (ty, digits) = match value {
        Literal::F64(value) => ("lreal", format!("{value:?}")),
        Literal::F32(value) => ("real", format!("{value:?}")),
        other => panic!("operands: {other:?} is not a real"),
    };
    match digits.as_str() {
        "0.0" => format!("{ty}_zero"),
        "1.0" => format!("{ty}_one"),
        digits => format!("{ty}_{}", digits.trim_end_matches(".0").replace('.', "p").replace('-', "m")),
    }
}
