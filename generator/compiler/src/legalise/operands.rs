//! Names every real number that is an operand in single precision: its digits would be LREAL, and make the whole expression
//! LREAL. In double precision the digits stay.

use crate::pass::Defect;
use crate::program::{Constant, Expr, Origin, Program, Var, map_expressions};
use portable::{Literal, RealKind};

/// The program with its numbers among the constants; a number that is assigned alone stays.
pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    if program.real == RealKind::F64 {
        return Ok(program);
    }
    let first = program.constants.len();
    let constants = &mut program.constants;
    let mut name = |part: &mut Expr| {
        if let Expr::Literal(value @ Literal::F32(number)) = *part {
            let known = constants[first..].iter().position(|constant| constant.value == value);
            let number = known.unwrap_or_else(|| {
                let doc = "a number of the algorithm: its digits in a statement would be LREAL";
                constants.push(Constant { path: name_of(number), doc, value, origin: Origin::Function });
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

/// The name of a number: `real_zero`, `real_one`, else its digits, as in `real_0p5`.
fn name_of(number: f32) -> String {
    let digits = format!("{number:?}");
    match digits.as_str() {
        "0.0" => "real_zero".to_owned(),
        "1.0" => "real_one".to_owned(),
        digits => format!("real_{}", digits.trim_end_matches(".0").replace('.', "p").replace('-', "m")),
    }
}
