//! The value of a cell: a real in decimal or as the hexadecimal digits of its bits, an integer, a BOOL.

use crate::samples::Signal;
use compiler::program::Type;
use portable::{Literal, RealKind};

/// The value of a cell.
#[must_use]
pub fn parse(cell: &str, signal: &Signal, real: RealKind) -> Option<Literal> {
    match (signal.ty, real) {
        (Type::Bool, _) => match cell {
            "0" | "FALSE" | "False" | "false" => Some(Literal::Bool(false)),
            "1" | "TRUE" | "True" | "true" => Some(Literal::Bool(true)),
            _ => None,
        },
        (Type::I32, _) => cell.parse().ok().map(Literal::I32),
        (Type::U32, _) => cell.parse().ok().map(Literal::U32),
        (Type::Real, RealKind::F64) => match cell.strip_prefix("0x") {
            Some(digits) => bits(digits, 16).map(|bits| Literal::F64(f64::from_bits(bits))),
            None => cell.parse().ok().filter(|x: &f64| x.is_finite() || is_named(cell)).map(Literal::F64),
        },
        (Type::Real, RealKind::F32) => match cell.strip_prefix("0x") {
            Some(digits) => Some(Literal::F32(f32::from_bits(u32::try_from(bits(digits, 8)?).ok()?))),
            None => cell.parse().ok().filter(|x: &f32| x.is_finite() || is_named(cell)).map(Literal::F32),
        },
    }
}

/// Whether a number that is not finite is meant: `inf`, `NaN`; a number too large for its type is not.
fn is_named(cell: &str) -> bool {
    !cell.contains(|c: char| c.is_ascii_digit())
}

/// A number of exactly this many hexadecimal digits.
fn bits(digits: &str, count: usize) -> Option<u64> {
    u64::from_str_radix(digits, 16).ok().filter(|_| digits.len() == count)
}

pub(crate) fn allowed(ty: Type, real: RealKind) -> &'static str {
    match (ty, real) {
        (Type::Bool, _) => "0 or 1, TRUE or FALSE",
        (Type::I32, _) => "an integer from -2147483648 to 2147483647",
        (Type::U32, _) => "an integer from 0 to 4294967295",
        (Type::Real, RealKind::F64) => "a decimal number, or 0x and 16 hexadecimal digits",
        (Type::Real, RealKind::F32) => "a decimal number, or 0x and 8 hexadecimal digits",
    }
}

/// The remedy for such a cell; empty if the allowed values are sufficient.
pub(crate) fn instead(cell: &str, ty: Type, real: RealKind) -> &'static str {
    match (ty, real, cell.strip_prefix("0x").map(str::len)) {
        (Type::Real, RealKind::F64, Some(8)) => "real = \"f32\" in the set: 8 digits are those of REAL",
        (Type::Real, RealKind::F32, Some(16)) => "real = \"f64\" in the set: 16 digits are those of LREAL",
        _ => "",
    }
}
