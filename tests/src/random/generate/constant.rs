//! Constants: the values that are most likely to be treated wrongly, next to ordinary ones.

use crate::random::choices::Choices;
use crate::random::syntax::{Scalar, Value};

/// The largest `usize` that is not a loop variable: an index below 3 is within every array that it is used in.
pub const LARGEST_KNOWN: usize = 2;

/// Reals that are finite in both real types: zeros, ones, powers of two, others, a subnormal of f32, large ones.
const REALS: [f64; 16] =
    [0.5, 2.0, -1.0, 1.0, 0.0, -0.0, 0.1, -0.25, 3.0, 10.0, -7.5, 1.0e-3, 1.0e-30, 1.0e-40, 1.0e30, -3.0e38];

const SIGNED: [i32; 10] = [0, 1, -1, 2, 3, -5, 100, 65_536, i32::MAX, i32::MIN];
const UNSIGNED: [u32; 9] = [0, 1, 2, 3, 5, 100, 65_536, 2_147_483_648, u32::MAX];

/// A constant of a type. `variants` is how many each enum has.
pub fn value(scalar: Scalar, variants: &[usize], choices: &mut Choices) -> Value {
    match scalar {
        Scalar::Real => real(choices),
        Scalar::Bool => Value::Bool(choices.chance(50)),
        Scalar::I32 => Value::I32(SIGNED[less_often_last(SIGNED.len(), choices)]),
        Scalar::U32 => Value::U32(UNSIGNED[less_often_last(UNSIGNED.len(), choices)]),
        Scalar::Usize => Value::Usize(choices.between(0, LARGEST_KNOWN)),
        Scalar::Enum(which) => Value::Variant(which, choices.below(variants[which])),
    }
}

fn real(choices: &mut Choices) -> Value {
    match choices.weighted(&[15, 12, 55, 6, 12]) {
        0 => Value::Zero,
        1 => Value::One,
        2 => Value::Lit(REALS[less_often_last(REALS.len(), choices)]),
        3 => *choices.pick(&[Value::PerKind(1.0e-30, 1.0e-18), Value::PerKind(0.1, 0.1), Value::PerKind(-2.0, 0.75)]),
        _ => Value::Lit(f64::from(u8::try_from(choices.below(200)).unwrap_or(0)) / 16.0 - 6.0),
    }
}

/// A position; the second half, where the extreme values are, in one case of four.
fn less_often_last(len: usize, choices: &mut Choices) -> usize {
    if choices.chance(75) { choices.below(len / 2) } else { choices.below(len) }
}
