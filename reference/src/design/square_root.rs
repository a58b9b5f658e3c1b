//! The square root, correctly rounded.

#![expect(clippy::field_reassign_with_default, reason = "the portable subset has no values of structs")]

use portable::{Real, portable};

/// A number as square * factor^2.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Scaled<R> {
    /// what is left of the number
    pub square: R,
    /// power of 2
    pub factor: R,
}

/// The square root of 4^-16 <= x <= 4^16, correctly rounded: the bits of a processor's own square root. 0 if x <= 0.
///
/// x is scaled by powers of 4 to 1 <= x < 4. A line and four of Heron's steps leave an error of about one unit in the last
/// place. The last step adds the remainder x - y^2, with y^2 as an exact sum of two numbers (Dekker 1971). Its error before
/// the last rounding is below the distance of every root from the middle of two neighbours, except for a short list of
/// arguments, which was tried; the bound of the last line is for x = 4 - 2^-51.
#[portable]
pub fn square_root<R: Real>(x: R) -> R {
    let mut root = R::ZERO;
    if x > R::ZERO {
        let mut scaled = Scaled::<R>::default();
        scaled.square = x;
        scaled.factor = R::ONE;
        scale(&mut scaled, R::lit(65_536.0), R::lit(256.0));
        scale(&mut scaled, R::lit(256.0), R::lit(16.0));
        scale(&mut scaled, R::lit(16.0), R::lit(4.0));
        scale(&mut scaled, R::lit(4.0), R::lit(2.0));
        if scaled.square < R::ONE {
            scaled.square = scaled.square * R::lit(4.0);
            scaled.factor = scaled.factor / R::lit(2.0);
        } else if scaled.square >= R::lit(4.0) {
            scaled.square = scaled.square / R::lit(4.0);
            scaled.factor = scaled.factor * R::lit(2.0);
        }
        root = from_1_to_4(scaled.square) * scaled.factor;
    }
    root
}

/// Brings the number nearer to 1 by the factor, which is `root` squared, if it is a factor or more away.
#[portable]
pub fn scale<R: Real>(scaled: &mut Scaled<R>, factor: R, root: R) {
    if scaled.square >= factor {
        scaled.square = scaled.square / factor;
        scaled.factor = scaled.factor * root;
    } else if scaled.square * factor < R::ONE {
        scaled.square = scaled.square * factor;
        scaled.factor = scaled.factor / root;
    }
}

/// The square root of 1 <= x < 4.
#[portable]
pub fn from_1_to_4<R: Real>(x: R) -> R {
    let first = R::lit(0.686_29) + R::lit(0.343_14) * x;
    let second = nearer(first, x);
    let third = nearer(second, x);
    let fourth = nearer(third, x);
    let y = nearer(fourth, x);
    // y = h + l, h of 26 bits: Veltkamp's split by 2^27 + 1
    let t = R::lit(134_217_729.0) * y;
    let h = t - (t - y);
    let l = y - h;
    // y^2 = p + e, exactly
    let p = y * y;
    let e = ((h * h - p) + R::lit(2.0) * (h * l)) + l * l;
    let root = y + ((x - p) - e) / (R::lit(2.0) * y);
    let below_2 = R::lit(1.999_999_999_999_999_8);
    if root > below_2 { below_2 } else { root }
}

/// Heron's step.
#[portable]
pub fn nearer<R: Real>(y: R, x: R) -> R {
    R::lit(0.5) * (y + x / y)
}
