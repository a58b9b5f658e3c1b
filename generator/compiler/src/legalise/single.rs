//! Splits statements on REAL into one operation each: a compiler that evaluates an expression in double precision then
//! rounds each result once, where it is assigned. The double of an operation on two REALs, rounded to REAL, equals the
//! result in REAL.
//!
//! ```text
//! y := a * x + s;   ->   a_times_x := a * x; y := a_times_x + s;
//! ```

use super::before::{self, Before};
use crate::pass::Defect;
use crate::program::{Expr, Program, Type};
use portable::{Binary, Intrinsic, RealKind, Unary};

/// A longer name is replaced by that of its first operand.
const LONGEST: usize = 48;

pub(super) fn run(program: Program) -> Result<Program, Defect> {
    if program.real == RealKind::F64 {
        return Ok(program);
    }
    Ok(before::run(program, |expr, before| {
        // An expression that is assigned as a whole already has a variable.
        if rounds(expr, before) {
            expr.change_operands(|operand| part(operand, before));
        } else {
            part(expr, before);
        }
    }))
}

/// Names the operations in an expression, inner ones first. A sign is only printed before a variable: the operand of a sign
/// has no sign, and neither has the bound of a magnitude, before which one is printed.
fn part(expr: &mut Expr, before: &mut Before<'_>) {
    let signed = match expr {
        Expr::Unary(Unary::Negate, _) => Some(0),
        Expr::Intrinsic(Intrinsic::InRange | Intrinsic::Within, _) => Some(1),
        _ => None,
    };
    let mut index = 0;
    expr.change_operands(|operand| {
        part(operand, before);
        let is_negative = matches!(operand, Expr::Unary(Unary::Negate, _)) && operand.ty(before.program) == Type::Real;
        if Some(index) == signed && is_negative {
            let path = name_of(operand, before);
            before.take(operand, path, Type::Real);
        }
        index += 1;
    });
    if rounds(expr, before) {
        let path = name_of(expr, before);
        before.take(expr, path, Type::Real);
    }
}

/// Whether this is an operation on reals whose result is rounded.
fn rounds(expr: &Expr, before: &Before<'_>) -> bool {
    match expr {
        Expr::Binary(Binary::Add | Binary::Subtract | Binary::Multiply | Binary::Divide, ..) => {
            expr.ty(before.program) == Type::Real
        }
        Expr::Intrinsic(Intrinsic::FromU32 | Intrinsic::FromI32, _) => true,
        _ => false,
    }
}

/// The name of an operation: `stage[0].filter[0].section[0].a2_times_y`, below the longest path of its operands.
fn name_of(expr: &Expr, before: &Before<'_>) -> String {
    let (mut place, mut names) = ("", Vec::new());
    for operand in expr.operands() {
        let unsigned = if let Expr::Unary(Unary::Negate, inner) = operand { inner } else { operand };
        let Expr::Var(var) = *unsigned else { continue };
        let path = before.program.path(var);
        let (above, name) = path.rsplit_once('.').unwrap_or(("", path));
        if above.len() > place.len() {
            place = above;
        }
        names.push(name);
    }
    let word = match expr {
        Expr::Binary(Binary::Add, ..) => "_plus_",
        Expr::Binary(Binary::Subtract, ..) => "_minus_",
        Expr::Binary(Binary::Divide, ..) => "_over_",
        Expr::Binary(..) => "_times_",
        Expr::Unary(..) => "_negated",
        _ => "_as_real",
    };
    let mut name = match names[..] {
        [] => "number".to_owned(),
        [only] => format!("{only}{}", word.trim_end_matches('_')),
        [left, right, ..] => format!("{left}{word}{right}"),
    };
    if let (true, Some(first)) = (name.len() > LONGEST, names.first()) {
        name = format!("{}_part", first.split("_part").next().unwrap_or(first));
    }
    if place.is_empty() { name } else { format!("{place}.{name}") }
}
