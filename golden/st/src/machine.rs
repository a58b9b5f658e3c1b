//! The numbered, typed slots of a lowered block, and the execution of its operations.

use super::op::{Code, Op};
use portable::{Real, RealKind};
use std::cmp::Ordering;

/// The contents of the slots: variables, numbers of the text, and parts of expressions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Slots<R> {
    /// REAL or LREAL
    pub(crate) reals: Vec<R>,
    pub(crate) bools: Vec<bool>,
    /// DINT and UDINT
    pub(crate) words: Vec<u32>,
    /// whether an operand of a comparison was a NaN
    pub(crate) compared_a_nan: bool,
}

impl<R: Real> Slots<R> {
    /// A fresh instance.
    pub(crate) fn start(from: &Slots<f64>) -> Self {
        let reals = from.reals.iter().map(|&value| R::lit(value)).collect();
        Self { reals, bools: from.bools.clone(), words: from.words.clone(), compared_a_nan: false }
    }

    /// One cycle. Every jump goes forward. If `MIXED`, doubles hold the reals of a block of REAL: an operation that is not
    /// wide rounds its result to REAL, and so does one that writes a variable.
    pub(crate) fn cycle<const MIXED: bool>(&mut self, ops: &[Op]) {
        let Self { reals, bools, words, compared_a_nan } = self;
        let kept = |op: &Op, value: R| if MIXED && !(op.wide && op.part) { in_single(value) } else { value };
        let mut next = 0;
        while let Some(op) = ops.get(next) {
            next += 1;
            let [to, a, b, c] = [op.to, op.a, op.b, op.c].map(|slot| slot as usize);
            match op.code {
                Code::MoveReal => reals[to] = kept(op, reals[a]),
                Code::NegateReal => reals[to] = kept(op, -reals[a]),
                Code::AddReal => reals[to] = kept(op, reals[a] + reals[b]),
                Code::SubtractReal => reals[to] = kept(op, reals[a] - reals[b]),
                Code::MultiplyReal => reals[to] = kept(op, reals[a] * reals[b]),
                Code::DivideReal => reals[to] = kept(op, reals[a] / reals[b]),
                Code::FusedAdd => reals[to] = kept(op, fused::<R, MIXED>(op, [reals[a], reals[b], reals[c]])),
                Code::FusedSubtract => reals[to] = kept(op, fused::<R, MIXED>(op, [reals[a], reals[b], -reals[c]])),
                Code::FusedSubtractFrom => {
                    reals[to] = kept(op, fused::<R, MIXED>(op, [-reals[a], reals[b], reals[c]]));
                }
                Code::LessReal => bools[to] = order(reals[a], reals[b], compared_a_nan).is_some_and(Ordering::is_lt),
                Code::AtMostReal => bools[to] = order(reals[a], reals[b], compared_a_nan).is_some_and(Ordering::is_le),
                Code::EqualReal => bools[to] = order(reals[a], reals[b], compared_a_nan) == Some(Ordering::Equal),
                Code::UnequalReal => bools[to] = order(reals[a], reals[b], compared_a_nan) != Some(Ordering::Equal),
                Code::MoveBool => bools[to] = bools[a],
                Code::Not => bools[to] = !bools[a],
                Code::And => bools[to] = bools[a] & bools[b],
                Code::Or => bools[to] = bools[a] | bools[b],
                Code::EqualBool => bools[to] = bools[a] == bools[b],
                Code::UnequalBool => bools[to] = bools[a] != bools[b],
                Code::MoveWord => words[to] = words[a],
                Code::NegateWord => words[to] = words[a].wrapping_neg(),
                Code::AddWord => words[to] = words[a].wrapping_add(words[b]),
                Code::SubtractWord => words[to] = words[a].wrapping_sub(words[b]),
                Code::MultiplyWord => words[to] = words[a].wrapping_mul(words[b]),
                Code::DivideDint => words[to] = of_dints(i32::wrapping_div, words[a], words[b]),
                Code::RemainderDint => words[to] = of_dints(i32::wrapping_rem, words[a], words[b]),
                Code::DivideUdint => words[to] = words[a] / words[b],
                Code::RemainderUdint => words[to] = words[a] % words[b],
                Code::EqualWord => bools[to] = words[a] == words[b],
                Code::UnequalWord => bools[to] = words[a] != words[b],
                Code::LessDint => bools[to] = words[a].cast_signed() < words[b].cast_signed(),
                Code::AtMostDint => bools[to] = words[a].cast_signed() <= words[b].cast_signed(),
                Code::LessUdint => bools[to] = words[a] < words[b],
                Code::AtMostUdint => bools[to] = words[a] <= words[b],
                // Every DINT is exact as a double: the only rounding is the one to the real type.
                Code::RealOfDint => reals[to] = kept(op, R::lit(f64::from(words[a].cast_signed()))),
                Code::RealOfUdint => reals[to] = kept(op, R::from_u32(words[a])),
                Code::Truncate => words[to] = truncated(reals[a]).cast_unsigned(),
                Code::Single => reals[to] = in_single(reals[a]),
                Code::Narrow => words[to] = narrowed(words[a].cast_signed()).cast_unsigned(),
                Code::ElementReal => reals[to] = kept(op, element(reals, a, words[b], c).unwrap_or(R::lit(f64::NAN))),
                Code::ElementBool => bools[to] = element(bools, a, words[b], c).unwrap_or(true),
                Code::ElementWord => words[to] = element(words, a, words[b], c).unwrap_or(0x5555_5555),
                Code::InRange => bools[to] = in_range(reals[a], reals[b]),
                Code::Jump => next = to,
                Code::JumpUnless if bools[a] => {}
                Code::JumpUnless => next = to,
            }
        }
    }
}

/// The order of two reals; notes a NaN, which has none.
fn order<R: PartialOrd>(a: R, b: R, compared_a_nan: &mut bool) -> Option<Ordering> {
    let found = a.partial_cmp(&b);
    *compared_a_nan |= found.is_none();
    found
}

/// An element of an array. Outside of it implementations disagree: then the result is a value that a reference does not have by
/// chance.
fn element<T: Copy>(slots: &[T], first: usize, index: u32, length: usize) -> Option<T> {
    let index = index as usize;
    if index < length { slots.get(first + index).copied() } else { None }
}

/// The value rounded to single precision.
fn in_single<R: Real>(value: R) -> R {
    R::lit(f64::from(f32::lit(value.to_f64())))
}

/// `x * y + z`, rounded once to the precision of the operation.
fn fused<R: Real, const MIXED: bool>(op: &Op, values: [R; 3]) -> R {
    let [x, y, z] = values.map(R::to_f64);
    if R::KIND == RealKind::F32 || MIXED && !op.wide {
        R::lit(f64::from(f32::lit(x).mul_add(f32::lit(y), f32::lit(z))))
    } else {
        R::lit(x.mul_add(y, z))
    }
}

/// The result of the function `F_axgen_in_range` in the emitted files.
fn in_range<R: Real>(x: R, limit: R) -> bool {
    x.to_f64().is_finite() && -limit <= x && x <= limit
}

/// `DINT_TO_INT`. Out of the range of an INT implementations disagree: then the result is a value that a reference does not
/// have by chance.
fn narrowed(value: i32) -> i32 {
    i32::from(i16::try_from(value).unwrap_or(0x5555))
}

/// `TRUNC`. Out of the range of a DINT implementations disagree: then the result is a value that a reference does not have
/// by chance.
fn truncated<R: Real>(x: R) -> i32 {
    if portable::is_within_i32(x.to_f64()) { x.truncated() } else { 0x5555_5555 }
}

/// An operation on two words as DINT.
fn of_dints(operation: fn(i32, i32) -> i32, a: u32, b: u32) -> u32 {
    operation(a.cast_signed(), b.cast_signed()).cast_unsigned()
}
