//! The real type that an algorithm is generic over: `f64` or `f32`, with arithmetic and comparison only.

use crate::{Literal, Portable, Ty};
use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// Which real type an instance uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RealKind {
    /// IEEE 754 binary64: C `double`, ST `LREAL`
    F64,
    /// IEEE 754 binary32: C `float`, ST `REAL`
    F32,
}

/// The real type of a portable algorithm. Every operation rounds once, to nearest, ties to even.
pub trait Real:
    Portable
    + Copy
    + Send
    + 'static
    + Debug
    + Display
    + Default
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + 'static
{
    /// Which one it is.
    const KIND: RealKind;
    /// Whether its arithmetic has double precision for numbers that a block in single precision takes: [`Wide`].
    const IS_FOR_SINGLE: bool = false;
    /// 0
    const ZERO: Self;
    /// 1
    const ONE: Self;

    /// `value` rounded to this type. Coefficients are computed in f64 and rounded here, once.
    fn lit(value: f64) -> Self;

    /// A constant with a separate value in each real type.
    fn per_kind(double: f64, single: f32) -> Self;

    /// The integer as a real, rounded to nearest.
    fn from_u32(value: u32) -> Self;

    /// The integer as a real, rounded to nearest.
    fn from_i32(value: i32) -> Self;

    /// The integer part of a number within the range of the integer, rounded towards 0.
    ///
    /// # Panics
    /// In a debug build, if the number is out of range: the conversion is undefined in C.
    fn truncated(self) -> i32;

    /// The value as f64, exactly.
    fn to_f64(self) -> f64;

    /// The value of a real literal of this type.
    ///
    /// # Panics
    /// If the literal is of another type.
    fn from_literal(literal: Literal) -> Self {
        Self::build(&mut || literal)
    }
}

impl Real for f64 {
    const KIND: RealKind = RealKind::F64;
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    fn lit(value: f64) -> Self {
        value
    }

    fn per_kind(double: f64, _: f32) -> Self {
        double
    }

    fn from_u32(value: u32) -> Self {
        Self::from(value)
    }

    fn from_i32(value: i32) -> Self {
        Self::from(value)
    }

    #[expect(clippy::cast_possible_truncation, reason = "that is what it does")]
    fn truncated(self) -> i32 {
        debug_assert!(is_within_i32(self.to_f64()), "truncate: {self} is beyond the range");
        self as i32
    }

    fn to_f64(self) -> f64 {
        self
    }
}

impl Real for f32 {
    const KIND: RealKind = RealKind::F32;
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    #[expect(clippy::cast_possible_truncation, reason = "this is the one rounding to single precision")]
    fn lit(value: f64) -> Self {
        value as Self
    }

    fn per_kind(_: f64, single: f32) -> Self {
        single
    }

    fn from_u32(value: u32) -> Self {
        value as Self
    }

    fn from_i32(value: i32) -> Self {
        value as Self
    }

    #[expect(clippy::cast_possible_truncation, reason = "that is what it does")]
    fn truncated(self) -> i32 {
        debug_assert!(is_within_i32(self.to_f64()), "truncate: {self} is beyond the range");
        self as i32
    }

    fn to_f64(self) -> f64 {
        f64::from(self)
    }
}

/// Double precision in a block that makes the numbers of a block in single precision: constants and structure are those of single
/// precision, the arithmetic is that of `f64`.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Wide(pub f64);

impl Display for Wide {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        Display::fmt(&self.0, f)
    }
}

macro_rules! operations {
    ($($operation:ident $method:ident),+; $($assignment:ident $assign:ident),+) => {
        $(impl $operation for Wide {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        })+
        $(impl $assignment for Wide {
            fn $assign(&mut self, other: Self) {
                self.0.$assign(other.0);
            }
        })+
    };
}

operations!(Add add, Sub sub, Mul mul, Div div; AddAssign add_assign, SubAssign sub_assign, MulAssign mul_assign);

impl Neg for Wide {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Portable for Wide {
    const TY: Ty = <f64 as Portable>::TY;

    fn visit(&self, visit: &mut dyn FnMut(Literal)) {
        self.0.visit(visit);
    }

    fn build(next: &mut dyn FnMut() -> Literal) -> Self {
        Self(f64::build(next))
    }
}

impl Real for Wide {
    const KIND: RealKind = RealKind::F64;
    const IS_FOR_SINGLE: bool = true;
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);

    fn lit(value: f64) -> Self {
        Self(value)
    }

    fn per_kind(_: f64, single: f32) -> Self {
        Self(f64::from(single))
    }

    fn from_u32(value: u32) -> Self {
        Self(f64::from(value))
    }

    fn from_i32(value: i32) -> Self {
        Self(f64::from(value))
    }

    fn truncated(self) -> i32 {
        self.0.truncated()
    }

    fn to_f64(self) -> f64 {
        self.0
    }
}

/// Whether the integer part of a number is an i32, so that it may be truncated.
#[must_use]
pub fn is_within_i32(x: f64) -> bool {
    -2_147_483_649.0 < x && x < 2_147_483_648.0
}
