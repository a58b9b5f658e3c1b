//! Operators on values, in the arithmetic of their own type: what folding and the interpreter agree on.
//!
//! Integers wrap around, reals round to nearest, comparisons with a NaN are false. An operator that does not fit its
//! operands is a defect that the typing pass has excluded.

use portable::{Binary, Intrinsic, Literal, RealKind, Unary};

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
    use Binary::{Add, And, Divide, Multiply, Or, Subtract};
    match (operator, left, right) {
        (Add, Literal::F64(a), Literal::F64(b)) => Literal::F64(a + b),
        (Subtract, Literal::F64(a), Literal::F64(b)) => Literal::F64(a - b),
        (Multiply, Literal::F64(a), Literal::F64(b)) => Literal::F64(a * b),
        (Divide, Literal::F64(a), Literal::F64(b)) => Literal::F64(a / b),
        (Add, Literal::F32(a), Literal::F32(b)) => Literal::F32(a + b),
        (Subtract, Literal::F32(a), Literal::F32(b)) => Literal::F32(a - b),
        (Multiply, Literal::F32(a), Literal::F32(b)) => Literal::F32(a * b),
        (Divide, Literal::F32(a), Literal::F32(b)) => Literal::F32(a / b),
        (Add, Literal::I32(a), Literal::I32(b)) => Literal::I32(a.wrapping_add(b)),
        (Subtract, Literal::I32(a), Literal::I32(b)) => Literal::I32(a.wrapping_sub(b)),
        (Multiply, Literal::I32(a), Literal::I32(b)) => Literal::I32(a.wrapping_mul(b)),
        (Add, Literal::U32(a), Literal::U32(b)) => Literal::U32(a.wrapping_add(b)),
        (Subtract, Literal::U32(a), Literal::U32(b)) => Literal::U32(a.wrapping_sub(b)),
        (Multiply, Literal::U32(a), Literal::U32(b)) => Literal::U32(a.wrapping_mul(b)),
        (Add, Literal::Usize(a), Literal::Usize(b)) => Literal::Usize(a + b),
        (Subtract, Literal::Usize(a), Literal::Usize(b)) => Literal::Usize(a - b),
        (Multiply, Literal::Usize(a), Literal::Usize(b)) => Literal::Usize(a * b),
        (And, Literal::Bool(a), Literal::Bool(b)) => Literal::Bool(a && b),
        (Or, Literal::Bool(a), Literal::Bool(b)) => Literal::Bool(a || b),
        _ => Literal::Bool(compare(operator, left, right)),
    }
}

/// The value of an operation that each target prints in its own way.
///
/// # Panics
/// If it does not fit the operands.
#[must_use]
pub fn intrinsic(intrinsic: Intrinsic, operands: &[Literal], real: RealKind) -> Literal {
    match (intrinsic, operands) {
        (Intrinsic::InRange | Intrinsic::Within, [Literal::F64(x), Literal::F64(limit)]) => {
            Literal::Bool(portable::within(*x, *limit))
        }
        (Intrinsic::InRange | Intrinsic::Within, [Literal::F32(x), Literal::F32(limit)]) => {
            Literal::Bool(portable::within(*x, *limit))
        }
        (Intrinsic::FromU32, [Literal::U32(value)]) => match real {
            RealKind::F64 => Literal::F64(portable::from_u32(*value)),
            RealKind::F32 => Literal::F32(portable::from_u32(*value)),
        },
        (Intrinsic::FromI32, [Literal::I32(value)]) => match real {
            RealKind::F64 => Literal::F64(portable::from_i32(*value)),
            RealKind::F32 => Literal::F32(portable::from_i32(*value)),
        },
        (Intrinsic::Truncate, [Literal::F64(x)]) => Literal::I32(portable::truncate(*x)),
        (Intrinsic::Truncate, [Literal::F32(x)]) => Literal::I32(portable::truncate(*x)),
        (Intrinsic::Nearest, [Literal::F64(x)]) => Literal::I32(portable::nearest(*x)),
        (Intrinsic::Nearest, [Literal::F32(x)]) => Literal::I32(portable::nearest(*x)),
        _ => panic!("arithmetic: {intrinsic:?} of {operands:?}"),
    }
}

fn compare(operator: Binary, left: Literal, right: Literal) -> bool {
    let (equality, order) = match (left, right) {
        (Literal::F64(a), Literal::F64(b)) => (None, a.partial_cmp(&b)),
        (Literal::F32(a), Literal::F32(b)) => (None, a.partial_cmp(&b)),
        (Literal::I32(a), Literal::I32(b)) => (Some(a == b), Some(a.cmp(&b))),
        (Literal::U32(a), Literal::U32(b)) => (Some(a == b), Some(a.cmp(&b))),
        (Literal::Usize(a), Literal::Usize(b)) => (Some(a == b), Some(a.cmp(&b))),
        (Literal::Variant(a), Literal::Variant(b)) => (Some(a == b), Some(a.cmp(&b))),
        (Literal::Bool(a), Literal::Bool(b)) => (Some(a == b), None),
        _ => (None, None),
    };
    match (operator, equality) {
        (Binary::Equal, Some(equal)) => equal,
        (Binary::NotEqual, Some(equal)) => !equal,
        (Binary::Less, _) => order.is_some_and(std::cmp::Ordering::is_lt),
        (Binary::LessEqual, _) => order.is_some_and(std::cmp::Ordering::is_le),
        (Binary::Greater, _) => order.is_some_and(std::cmp::Ordering::is_gt),
        (Binary::GreaterEqual, _) => order.is_some_and(std::cmp::Ordering::is_ge),
        _ => panic!("arithmetic: {operator:?} of {left:?} and {right:?}"),
    }
}

/// Whether a literal in a source file can carry the value: not an infinity, not a NaN.
#[must_use]
pub fn is_finite(value: Literal) -> bool {
    match value {
        Literal::F64(value) => value.is_finite(),
        Literal::F32(value) => value.is_finite(),
        _ => true,
    }
}

/// Whether the value is -0, which changes nothing that it is added to.
#[must_use]
pub fn is_negative_zero(value: Literal) -> bool {
    match value {
        Literal::F64(value) => value.to_bits() == (-0.0_f64).to_bits(),
        Literal::F32(value) => value.to_bits() == (-0.0_f32).to_bits(),
        _ => false,
    }
}
