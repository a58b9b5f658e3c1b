//! Operators on values, in the arithmetic of their own type, for both folding and the interpreter.
//!
//! Integers wrap around, reals round to nearest, comparisons with a NaN are false. An operator that does not fit its
//! operands is a defect, which the typing pass excludes.

use portable::{Binary, Intrinsic, Literal, RealKind, Unary};

/// The value of an operator with one operand.
///
/// # Panics
/// If the operator does not fit the operand.
pub fn unary(operator: Unary, operand: Literal) -> Literal {
    match (operator, operand) {
        (Unary::Negate, Literal::F64(a)) => Literal::F64(-a),
        (Unary::Negate, Literal::F32(a)) => Literal::F32(-a),
        (Unary::Negate, Literal::I32(a)) => Literal::I32(a.wrapping_neg()),
        (Unary::Not, Literal::Bool(a)) => Literal::Bool(!a),
        _ => panic!("arithmetic: {operator:?} of {operand:?}"),
    }
}

/// The value of an operator with two operands.
///
/// # Panics
/// If the operator does not fit the operands, or an index leaves its range.
pub fn binary(operator: Binary, left: Literal, right: Literal) -> Literal {
    use std::ops::{Add, Mul, Sub};
    let value = match (left, right, operator) {
        (Literal::F64(a), Literal::F64(b), Binary::Divide) => Some(Literal::F64(a / b)),
        (Literal::F32(a), Literal::F32(b), Binary::Divide) => Some(Literal::F32(a / b)),
        (Literal::F64(a), Literal::F64(b), _) => compute(operator, a, b, Literal::F64, [f64::add, f64::sub, f64::mul]),
        (Literal::F32(a), Literal::F32(b), _) => compute(operator, a, b, Literal::F32, [f32::add, f32::sub, f32::mul]),
        (Literal::I32(a), Literal::I32(b), Binary::Divide) => a.checked_div(b).map(Literal::I32),
        (Literal::I32(a), Literal::I32(b), Binary::Remainder) => a.checked_rem(b).map(Literal::I32),
        (Literal::U32(a), Literal::U32(b), Binary::Divide) => a.checked_div(b).map(Literal::U32),
        (Literal::U32(a), Literal::U32(b), Binary::Remainder) => a.checked_rem(b).map(Literal::U32),
        (Literal::I32(a), Literal::I32(b), _) => {
            compute(operator, a, b, Literal::I32, [i32::wrapping_add, i32::wrapping_sub, i32::wrapping_mul])
        }
        (Literal::U32(a), Literal::U32(b), _) => {
            compute(operator, a, b, Literal::U32, [u32::wrapping_add, u32::wrapping_sub, u32::wrapping_mul])
        }
        (Literal::Usize(a), Literal::Usize(b), _) => {
            compute(operator, a, b, Literal::Usize, [usize::add, usize::sub, usize::mul])
        }
        (Literal::Bool(a), Literal::Bool(b), Binary::And) => Some(Literal::Bool(a && b)),
        (Literal::Bool(a), Literal::Bool(b), Binary::Or) => Some(Literal::Bool(a || b)),
        (Literal::Bool(a), Literal::Bool(b), _) => compare(operator, a, b),
        (Literal::Variant(a), Literal::Variant(b), _) => compare(operator, a, b),
        _ => None,
    };
    value.unwrap_or_else(|| panic!("arithmetic: {operator:?} of {left:?} and {right:?}"))
}

fn compute<T: PartialOrd>(
    operator: Binary,
    a: T,
    b: T,
    literal: fn(T) -> Literal,
    [add, subtract, multiply]: [fn(T, T) -> T; 3],
) -> Option<Literal> {
    match operator {
        Binary::Add => Some(literal(add(a, b))),
        Binary::Subtract => Some(literal(subtract(a, b))),
        Binary::Multiply => Some(literal(multiply(a, b))),
        _ => compare(operator, a, b),
    }
}

fn compare<T: PartialOrd>(operator: Binary, a: T, b: T) -> Option<Literal> {
    Some(Literal::Bool(match operator {
        Binary::Less => a < b,
        Binary::LessEqual => a <= b,
        Binary::Greater => a > b,
        Binary::GreaterEqual => a >= b,
        Binary::Equal => a == b,
        Binary::NotEqual => a != b,
        _ => return None,
    }))
}

/// The value of an intrinsic operation.
pub(crate) fn intrinsic(intrinsic: Intrinsic, operands: &[Literal], kind: RealKind) -> Literal {
    match (intrinsic, operands, kind) {
        (Intrinsic::InRange | Intrinsic::Within, [Literal::F64(x), Literal::F64(limit)], _) => {
            Literal::Bool(portable::within(*x, *limit))
        }
        (Intrinsic::InRange | Intrinsic::Within, [Literal::F32(x), Literal::F32(limit)], _) => {
            Literal::Bool(portable::within(*x, *limit))
        }
        (Intrinsic::FromU32, [Literal::U32(x)], RealKind::F64) => Literal::F64(portable::from_u32(*x)),
        (Intrinsic::FromU32, [Literal::U32(x)], RealKind::F32) => Literal::F32(portable::from_u32(*x)),
        (Intrinsic::FromI32, [Literal::I32(x)], RealKind::F64) => Literal::F64(portable::from_i32(*x)),
        (Intrinsic::FromI32, [Literal::I32(x)], RealKind::F32) => Literal::F32(portable::from_i32(*x)),
        (Intrinsic::Narrow, [Literal::F64(x)], _) => Literal::F64(f64::from(<f32 as portable::Real>::lit(*x))),
        (Intrinsic::Unsigned, [Literal::I32(x)], _) => Literal::U32(portable::unsigned(*x)),
        (Intrinsic::Truncate, [Literal::F64(x)], _) => Literal::I32(portable::truncate(*x)),
        (Intrinsic::Truncate, [Literal::F32(x)], _) => Literal::I32(portable::truncate(*x)),
        (Intrinsic::Nearest, [Literal::F64(x)], _) => Literal::I32(portable::nearest(*x)),
        (Intrinsic::Nearest, [Literal::F32(x)], _) => Literal::I32(portable::nearest(*x)),
        _ => panic!("arithmetic: {intrinsic:?} of {operands:?}"),
    }
}

/// A real number as f64, exactly; `None` for any other value.
pub fn wide(value: Literal) -> Option<f64> {
    match value {
        Literal::F64(value) => Some(value),
        Literal::F32(value) => Some(value.into()),
        _ => None,
    }
}

/// Whether a literal in a source file can represent the value: neither an infinity nor a NaN.
pub(crate) fn is_finite(value: Literal) -> bool {
    wide(value).is_none_or(f64::is_finite)
}
