//! Operators on values, in the arithmetic of their own type: what folding and the interpreter agree on.
//!
//! Integers wrap around, reals round to nearest, comparisons with a NaN are false. An operator that does not fit its
//! operands is a defect that the typing pass has excluded.

use portable::{Binary, Intrinsic, Literal, Real, RealKind, Unary};
use std::cmp::Ordering;

/// The value of an operator with one operand.
///
/// # Panics
/// If the operator does not fit the operand.
#[must_use]
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
#[must_use]
pub fn binary(operator: Binary, left: Literal, right: Literal) -> Literal {
    use std::ops::{Add, Mul, Sub};
    let computed = match (left, right) {
        (Literal::F64(a), Literal::F64(b)) => real(operator, a, b).map(Literal::F64),
        (Literal::F32(a), Literal::F32(b)) => real(operator, a, b).map(Literal::F32),
        (Literal::I32(a), Literal::I32(b)) => {
            integer(operator, a, b, [i32::wrapping_add, i32::wrapping_sub, i32::wrapping_mul]).map(Literal::I32)
        }
        (Literal::U32(a), Literal::U32(b)) => {
            integer(operator, a, b, [u32::wrapping_add, u32::wrapping_sub, u32::wrapping_mul]).map(Literal::U32)
        }
        (Literal::Usize(a), Literal::Usize(b)) => {
            integer(operator, a, b, [usize::add, usize::sub, usize::mul]).map(Literal::Usize)
        }
        (Literal::Bool(a), Literal::Bool(b)) => match operator {
            Binary::And => Some(Literal::Bool(a && b)),
            Binary::Or => Some(Literal::Bool(a || b)),
            _ => None,
        },
        _ => None,
    };
    computed.unwrap_or_else(|| Literal::Bool(compare(operator, left, right)))
}

fn real<R: Real>(operator: Binary, a: R, b: R) -> Option<R> {
    match operator {
        Binary::Add => Some(a + b),
        Binary::Subtract => Some(a - b),
        Binary::Multiply => Some(a * b),
        Binary::Divide => Some(a / b),
        _ => None,
    }
}

fn integer<T>(operator: Binary, a: T, b: T, [add, subtract, multiply]: [fn(T, T) -> T; 3]) -> Option<T> {
    match operator {
        Binary::Add => Some(add(a, b)),
        Binary::Subtract => Some(subtract(a, b)),
        Binary::Multiply => Some(multiply(a, b)),
        _ => None,
    }
}

fn compare(operator: Binary, left: Literal, right: Literal) -> bool {
    let order = match (left, right) {
        (Literal::F64(a), Literal::F64(b)) => a.partial_cmp(&b),
        (Literal::F32(a), Literal::F32(b)) => a.partial_cmp(&b),
        (Literal::I32(a), Literal::I32(b)) => Some(a.cmp(&b)),
        (Literal::U32(a), Literal::U32(b)) => Some(a.cmp(&b)),
        (Literal::Usize(a), Literal::Usize(b)) => Some(a.cmp(&b)),
        (Literal::Variant(a), Literal::Variant(b)) => Some(a.cmp(&b)),
        (Literal::Bool(a), Literal::Bool(b)) => Some(a.cmp(&b)),
        _ => None,
    };
    match operator {
        Binary::Less => order.is_some_and(Ordering::is_lt),
        Binary::LessEqual => order.is_some_and(Ordering::is_le),
        Binary::Greater => order.is_some_and(Ordering::is_gt),
        Binary::GreaterEqual => order.is_some_and(Ordering::is_ge),
        // Reals are compared by order only, as the typing pass says.
        Binary::Equal if order.is_some() && wide(left).is_none() => order == Some(Ordering::Equal),
        Binary::NotEqual if order.is_some() && wide(left).is_none() => order != Some(Ordering::Equal),
        _ => panic!("arithmetic: {operator:?} of {left:?} and {right:?}"),
    }
}

/// The value of an operation that each target prints in its own way.
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
        (Intrinsic::Truncate, [Literal::F64(x)], _) => Literal::I32(portable::truncate(*x)),
        (Intrinsic::Truncate, [Literal::F32(x)], _) => Literal::I32(portable::truncate(*x)),
        (Intrinsic::Nearest, [Literal::F64(x)], _) => Literal::I32(portable::nearest(*x)),
        (Intrinsic::Nearest, [Literal::F32(x)], _) => Literal::I32(portable::nearest(*x)),
        _ => panic!("arithmetic: {intrinsic:?} of {operands:?}"),
    }
}

/// A real number as f64, exactly; `None`: another value.
pub(crate) fn wide(value: Literal) -> Option<f64> {
    match value {
        Literal::F64(value) => Some(value),
        Literal::F32(value) => Some(value.into()),
        _ => None,
    }
}

/// Whether a literal in a source file can carry the value: not an infinity, not a NaN.
pub(crate) fn is_finite(value: Literal) -> bool {
    wide(value).is_none_or(f64::is_finite)
}
