//! The possible values of a variable.

use super::real::Interval;
use super::whole::{Names, Whole, number};
use crate::arithmetic;
use crate::program::Type;
use portable::Literal;

/// The values that a variable may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// whether it may be FALSE, whether it may be TRUE
    Bool([bool; 2]),
    Whole(Whole),
    Real(Interval),
}

impl Value {
    /// Any bit pattern of a type.
    pub(super) fn any(ty: Type) -> Self {
        match ty {
            Type::Bool => Self::Bool([true; 2]),
            Type::I32 | Type::U32 => {
                let (low, high) = limits(ty);
                Self::Whole(Whole::numbers(low, high))
            }
            Type::Real => Self::Real(Interval::ANY),
        }
    }

    pub(super) fn one(literal: Literal, names: &Names) -> Self {
        match literal {
            Literal::Bool(value) => Self::Bool([!value, value]),
            literal => match (number(literal), arithmetic::wide(literal)) {
                (Some(number), _) => Self::Whole(names.one(number)),
                (_, Some(real)) => Self::Real(Interval::one(real)),
                _ => panic!("ranges: {literal:?} does not exist at run time"),
            },
        }
    }

    pub(super) fn join(self, other: Self, names: &Names) -> Self {
        match (self, other) {
            (Self::Bool(a), Self::Bool(b)) => Self::Bool([a[0] || b[0], a[1] || b[1]]),
            (Self::Whole(a), Self::Whole(b)) => Self::Whole(names.join(a, b)),
            (Self::Real(a), Self::Real(b)) => Self::Real(a.join(b)),
            _ => panic!("ranges: {self:?} and {other:?} are of two types"),
        }
    }

    pub(super) fn meet(self, other: Self, names: &Names) -> Self {
        match (self, other) {
            (Self::Bool(a), Self::Bool(b)) => Self::Bool([a[0] && b[0], a[1] && b[1]]),
            (Self::Whole(a), Self::Whole(b)) => Self::Whole(names.meet(a, b)),
            (Self::Real(a), Self::Real(b)) => Self::Real(a.meet(b)),
            _ => panic!("ranges: {self:?} and {other:?} are of two types"),
        }
    }

    pub(super) fn is_none(self) -> bool {
        match self {
            Self::Bool(may_be) => may_be == [false; 2],
            Self::Whole(whole) => whole.is_none(),
            Self::Real(interval) => interval.is_none(),
        }
    }

    /// Whether a value is among them.
    pub fn holds(self, literal: Literal) -> bool {
        match (self, literal) {
            (Self::Bool(may_be), Literal::Bool(value)) => may_be[usize::from(value)],
            (Self::Whole(whole), literal) => {
                number(literal).is_some_and(|number| whole.low <= number && number <= whole.high)
            }
            (Self::Real(interval), literal) => arithmetic::wide(literal).is_some_and(|real| {
                if real.is_nan() { interval.nan } else { interval.low <= real && real <= interval.high }
            }),
            _ => false,
        }
    }
}

/// Smallest and largest value of an integer type.
pub(super) fn limits(ty: Type) -> (i64, i64) {
    match ty {
        Type::U32 => (0, u32::MAX.into()),
        _ => (i32::MIN.into(), i32::MAX.into()),
    }
}
