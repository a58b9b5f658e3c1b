//! A defect of GCC that random programs meet: it computes `0.0 - (double)u` as `-(double)u`, which is -0.0 where `u` is 0.
//!
//! It does so at every level, -O0 included (GCC 12, x86-64 and ARM), wherever it sees that the subtrahend cannot be -0.0:
//! a conversion from an integer, alone or after an operation that changes nothing. Clang computes what is written.

use compiler::arithmetic;
use compiler::program::{Expr, Program, Var};
use portable::{Binary, Intrinsic, Literal, RealKind, Unary};

/// Whether a program subtracts a converted integer from 0.
#[must_use]
pub fn subtracts_integer_from_zero(program: &Program) -> bool {
    let mut found = false;
    for statement in program.statements() {
        statement.expressions(&mut |expr| expr.parts(&mut |part| found |= is_misread(part, program)));
    }
    found
}

fn is_misread(expr: &Expr, program: &Program) -> bool {
    let Expr::Binary(operator, left, right) = expr else { return false };
    let zero = |expr| value(expr, program).is_some_and(is_zero);
    let integer = |expr| is_integer(expr, program);
    match operator {
        Binary::Subtract => zero(left) && integer(right),
        Binary::Add => zero(left) && integer(right) || zero(right) && integer(left),
        _ => false,
    }
}

/// Whether an expression is a converted integer, perhaps with a sign, or after operations that change nothing.
fn is_integer(expr: &Expr, program: &Program) -> bool {
    let constant = |expr| value(expr, program).is_some();
    match expr {
        Expr::Intrinsic(Intrinsic::FromU32 | Intrinsic::FromI32, _) => true,
        Expr::Unary(Unary::Negate, operand) => is_integer(operand, program),
        Expr::Binary(_, left, right) => {
            constant(left) && is_integer(right, program) || constant(right) && is_integer(left, program)
        }
        _ => false,
    }
}

/// The value of an expression that a compiler knows.
fn value(expr: &Expr, program: &Program) -> Option<Literal> {
    match expr {
        Expr::Literal(literal) => Some(*literal),
        Expr::Var(Var::Constant(index)) => Some(program.constants[*index].value),
        Expr::Unary(operator, operand) => Some(arithmetic::unary(*operator, value(operand, program)?)),
        Expr::Binary(operator, left, right) => {
            Some(arithmetic::binary(*operator, value(left, program)?, value(right, program)?))
        }
        Expr::Intrinsic(Intrinsic::FromU32, operands) => match (value(&operands[0], program)?, program.real) {
            (Literal::U32(number), RealKind::F64) => Some(Literal::F64(portable::from_u32(number))),
            (Literal::U32(number), RealKind::F32) => Some(Literal::F32(portable::from_u32(number))),
            _ => None,
        },
        Expr::Intrinsic(Intrinsic::FromI32, operands) => match (value(&operands[0], program)?, program.real) {
            (Literal::I32(number), RealKind::F64) => Some(Literal::F64(portable::from_i32(number))),
            (Literal::I32(number), RealKind::F32) => Some(Literal::F32(portable::from_i32(number))),
            _ => None,
        },
        _ => None,
    }
}

fn is_zero(value: Literal) -> bool {
    matches!(value, Literal::F64(0.0) | Literal::F32(0.0))
}
