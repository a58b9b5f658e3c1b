//! Types and literals of C.

use crate::target::number::decimal;
use compiler::program::Type;
use portable::{Literal, RealKind};

/// The C name of a type.
#[must_use]
pub fn name(ty: Type, real: RealKind) -> &'static str {
    match (ty, real) {
        (Type::Bool, _) => "bool",
        (Type::I32, _) => "int32_t",
        (Type::U32, _) => "uint32_t",
        (Type::Real, RealKind::F64) => "double",
        (Type::Real, RealKind::F32) => "float",
    }
}

/// The unsigned integer that shows the bits of a real.
#[must_use]
pub fn bits_name(real: RealKind) -> &'static str {
    match real {
        RealKind::F64 => "uint64_t",
        RealKind::F32 => "uint32_t",
    }
}

/// The text of a literal; a negative one begins with `-` or `(`.
///
/// # Panics
/// If the literal does not exist at run time: the passes have excluded that.
#[must_use]
pub fn literal(value: Literal) -> String {
    match value {
        Literal::Bool(value) => value.to_string(),
        Literal::I32(i32::MIN) => "(-2147483647 - 1)".to_owned(),
        Literal::I32(value) => value.to_string(),
        Literal::U32(value) => format!("{value}u"),
        Literal::F64(_) => decimal(value),
        Literal::F32(_) => format!("{}f", decimal(value)),
        Literal::Usize(_) | Literal::Variant(_) => panic!("c: {value:?} has no counterpart"),
    }
}
