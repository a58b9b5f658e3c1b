//! Coefficients of double precision in the real type of a block, and the limits of that type.

use portable::{Literal, Portable, Real, RealKind};
use reference::signal;

/// The value with every real rounded once to the real type of `To`: [`Real::lit`]. `From` and `To` are one portable type
/// with two real types.
pub fn rounded<From: Portable, To: Portable>(value: &From, real: RealKind) -> To {
    let mut leaves = Vec::new();
    value.visit(&mut |leaf| {
        leaves.push(match (leaf, real) {
            (Literal::F64(value), RealKind::F32) => Literal::F32(f32::lit(value)),
            (leaf, _) => leaf,
        });
    });
    let mut leaves = leaves.into_iter();
    To::build(&mut || leaves.next().expect("design: both types have the same scalars"))
}

/// A number of double precision, rounded to the real type.
pub fn in_precision(value: f64, real: RealKind) -> f64 {
    if real == RealKind::F64 { value } else { f32::lit(value).into() }
}

/// A number of double precision, rounded to the real type, as a literal.
pub fn literal(value: f64, real: RealKind) -> Literal {
    if real == RealKind::F64 { Literal::F64(value) } else { Literal::F32(f32::lit(value)) }
}

/// The smallest number of a real type that is at least the given positive number.
pub fn at_least(value: f64, real: RealKind) -> Literal {
    let near = f32::lit(value);
    match real {
        RealKind::F64 => Literal::F64(value),
        RealKind::F32 => Literal::F32(if f64::from(near) < value { near.next_up() } else { near }),
    }
}

/// The largest number of a real type.
pub fn largest(real: RealKind) -> f64 {
    if real == RealKind::F64 { f64::MAX } else { f32::MAX.into() }
}

/// The largest magnitude of a sample that a block accepts.
pub fn sample_limit(real: RealKind) -> f64 {
    if real == RealKind::F64 { signal::sample_limit() } else { signal::sample_limit::<f32>().into() }
}

/// The name of a real type's precision.
pub fn precision(real: RealKind) -> &'static str {
    if real == RealKind::F64 { "double" } else { "single" }
}
