//! What becomes of a value that something else has overwritten.

use portable::Literal;

/// The value with one of its bits the other way round: with the bit of this number, of 64, or its remainder where the value has 32.
///
/// # Panics
/// If it is a value that does not exist at run time.
#[must_use]
pub fn flipped(value: Literal, bit: usize) -> Literal {
    match value {
        Literal::F64(value) => Literal::F64(f64::from_bits(value.to_bits() ^ 1 << bit)),
        Literal::F32(value) => Literal::F32(f32::from_bits(value.to_bits() ^ 1 << (bit % 32))),
        Literal::U32(value) => Literal::U32(value ^ 1 << (bit % 32)),
        Literal::I32(value) => Literal::I32(value ^ 1 << (bit % 32)),
        Literal::Bool(value) => Literal::Bool(!value),
        other => panic!("{other:?} does not exist at run time"),
    }
}
