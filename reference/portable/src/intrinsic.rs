//! Operations that each target prints in its own way. They are called like any portable function.

use crate::Real;

/// Whether `x` is a number in range: `-limit <= x <= limit`. With a finite limit this is false for a NaN and for an
/// infinity, neither of which need be named.
///
/// A target whose runtime may stop at a comparison with a NaN looks at the exponent bits first.
#[must_use]
pub fn in_range<R: Real>(x: R, limit: R) -> bool {
    -limit <= x && x <= limit
}

/// Whether `-limit <= x <= limit`, for an `x` that is a number.
#[must_use]
pub fn within<R: Real>(x: R, limit: R) -> bool {
    -limit <= x && x <= limit
}

/// A comment that every target prints at its place: why a branch stands there that no input reaches. It does nothing.
pub fn note(_: &'static str) {}

/// The integer as a real, rounded to nearest. Exact below 2^24 in every real type.
#[must_use]
pub fn from_u32<R: Real>(value: u32) -> R {
    R::from_u32(value)
}

/// The integer as a real, rounded to nearest. Exact below 2^24 in every real type.
#[must_use]
pub fn from_i32<R: Real>(value: i32) -> R {
    R::from_i32(value)
}

/// The whole part of `x`: towards 0. It is asked only for -2^31 < x < 2^31, beyond which languages disagree, and stands
/// alone right of `let`: Structured Text takes the type of the result from the variable that gets it.
#[must_use]
pub fn truncate<R: Real>(x: R) -> i32 {
    x.truncated()
}

/// The nearest integer, of two that are as near the one away from 0. It is asked only for -2^31 < x < 2^31 - 1/2, and
/// stands alone right of `let` or `=`.
#[must_use]
pub fn nearest<R: Real>(x: R) -> i32 {
    truncate(if x >= R::ZERO { x + nearly_half() } else { x - nearly_half() })
}

/// The largest number below 1/2. Added before a number is truncated it rounds every number rightly, which 1/2 does not:
/// 1/2 and the number below it make 1.
#[must_use]
pub fn nearly_half<R: Real>() -> R {
    R::per_kind(0.499_999_999_999_999_94, 0.499_999_97)
}

macro_rules! intrinsic {
    ($name:ident, $intrinsic:ident, ($($param:ident: $type:ty),*) -> $returns:ty) => {
        #[doc(hidden)]
        pub mod $name {
            use crate::{Body, CodeBlock, Fn, Intrinsic, Mode, Param, Portable, Real};
            use core::marker::PhantomData;

            pub struct Ir<R>(PhantomData<R>);

            impl<R: Real> Ir<R> {
                pub const IR: Fn = Fn {
                    name: stringify!($name),
                    module: module_path!(),
                    doc: "",
                    params: &[$(Param { name: stringify!($param), mode: Mode::Value, ty: <$type as Portable>::TY }),*],
                    returns: Some(<$returns as Portable>::TY),
                    body: Body { intrinsic: Some(Intrinsic::$intrinsic), block: CodeBlock { statements: &[], value: None } },
                };
            }
        }
    };
}

intrinsic!(in_range, InRange, (x: R, limit: R) -> bool);
intrinsic!(within, Within, (x: R, limit: R) -> bool);
intrinsic!(from_u32, FromU32, (value: u32) -> R);
intrinsic!(from_i32, FromI32, (value: i32) -> R);
intrinsic!(truncate, Truncate, (x: R) -> i32);
intrinsic!(nearest, Nearest, (x: R) -> i32);
