//! Operations that each target prints in its own way. They are called like any portable function.

use crate::{Literal, Portable, Real, Ty};

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

/// A comment that every target prints at this place: why a branch exists that no input reaches. It has no effect.
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

/// The integer without a sign. It is asked only from 0 on: some runtimes stop at a negative one.
#[must_use]
pub fn unsigned(value: i32) -> u32 {
    value.cast_unsigned()
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

/// The value `structure` with every scalar that `numbers` has, too, taken from there: what stands at the same path. It stands
/// as an argument: `&with_numbers(&structure, &numbers)`. What `structure` alone says is known when a block is specialised, so
/// that it decides branches; the numbers are read where they are.
#[must_use]
pub fn with_numbers<T: Portable, N: Portable>(structure: &T, numbers: &N) -> T {
    let (mut fixed, mut other) = ([None; LARGEST], [None; LARGEST]);
    scalars(structure, &mut fixed);
    scalars(numbers, &mut other);
    overlaid(&T::TY, &N::TY, &mut |at, from| fixed[at] = other[from]);
    let mut leaves = fixed.into_iter().flatten();
    T::build(&mut || leaves.next().expect("with_numbers: all scalars of the type"))
}

/// The most scalars that [`with_numbers`] takes: the crate has no vectors, because it does not use the standard library.
const LARGEST: usize = 256;

fn scalars<T: Portable>(value: &T, scalars: &mut [Option<Literal>; LARGEST]) {
    let mut next = 0;
    value.visit(&mut |leaf| {
        scalars[next] = Some(leaf);
        next += 1;
    });
}

/// Calls `tell` for each scalar of a type that another type has at the same path, with its positions in both.
pub fn overlaid(ty: &Ty, other: &Ty, tell: &mut dyn FnMut(usize, usize)) {
    match (ty, other) {
        (Ty::Struct { def }, Ty::Struct { def: of_other }) => {
            for theirs in of_other.fields {
                let same = def.fields.iter().find(|ours| ours.name == theirs.name);
                let ours = same.expect("with_numbers: the structure has every field that the numbers have");
                overlaid(&ours.ty, &theirs.ty, &mut |at, from| tell(ours.first + at, theirs.first + from));
            }
        }
        (Ty::Array { element, len }, Ty::Array { element: of_other, .. }) => {
            for index in 0..*len {
                let (first, first_of_other) = (index * element.leaves(), index * of_other.leaves());
                overlaid(element, of_other, &mut |at, from| tell(first + at, first_of_other + from));
            }
        }
        _ => tell(0, 0),
    }
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
intrinsic!(unsigned, Unsigned, (value: i32) -> u32);
intrinsic!(truncate, Truncate, (x: R) -> i32);
intrinsic!(nearest, Nearest, (x: R) -> i32);
