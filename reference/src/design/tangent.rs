//! The tangent of an angle from 0 to 1.4138, which is pi 0.45 and a reserve for its rounding.
//!
//! Reduction, polynomial and constants are those of fdlibm (Sun Microsystems 1993 and 2004; `e_rem_pio2.c`, `k_tan.c`), and
//! each result has the bits of its `tan`: the error is below one unit in the last place. fdlibm clears the low word of two
//! numbers; [`leading`] does the same by arithmetic.

#![expect(clippy::needless_range_loop, reason = "the portable subset has one way to go through an array")]

use portable::{Real, portable};

/// 2^-27: the tangent of a smaller angle is the angle
const SMALLEST: f64 = 7.450_580_596_923_828e-9;
/// the smallest angle that is reduced by pi/2: pi/4 in its leading 32 bits and one more unit
const REDUCED: f64 = 0.785_398_483_276_367_2;
/// leading 33 bits of pi/2
const HALF_PI: f64 = 1.570_796_326_734_125_6;
/// pi/2 - `HALF_PI`
const HALF_PI_REST: f64 = 6.077_100_506_506_192e-11;
/// the smallest magnitude from which pi/4 - x is used
const BIG: f64 = 0.674_335_479_736_328_1;
/// pi/4, rounded
const QUARTER_PI: f64 = core::f64::consts::FRAC_PI_4;
/// pi/4 - `QUARTER_PI`
const QUARTER_PI_REST: f64 = 3.061_616_997_868_383e-17;

// tan x = x + T0 x^3 + T1 x^5 + ... + T12 x^27 up to `BIG`
const T0: f64 = 3.333_333_333_333_341e-1;
const T1: f64 = 1.333_333_333_332_012_4e-1;
const T2: f64 = 5.396_825_397_622_605e-2;
const T3: f64 = 2.186_948_829_485_954_2e-2;
const T4: f64 = 8.863_239_823_599_3e-3;
const T5: f64 = 3.592_079_107_591_312_4e-3;
const T6: f64 = 1.456_209_454_325_290_3e-3;
const T7: f64 = 5.880_412_408_202_641e-4;
const T8: f64 = 2.464_631_348_184_699e-4;
const T9: f64 = 7.817_944_429_395_571e-5;
const T10: f64 = 7.140_724_913_826_082e-5;
const T11: f64 = -1.855_863_748_552_754_6e-5;
const T12: f64 = 2.590_730_518_636_337e-5;

/// tan(angle), angle in rad, 0 <= angle <= 1.4138.
#[portable]
pub fn tangent<R: Real>(angle: R) -> R {
    let mut value = angle;
    if angle >= R::lit(SMALLEST) {
        let is_reduced = angle >= R::lit(REDUCED);
        let mut x = angle;
        let mut rest = R::ZERO;
        if is_reduced {
            let z = angle - R::lit(HALF_PI);
            x = z - R::lit(HALF_PI_REST);
            rest = (z - x) - R::lit(HALF_PI_REST);
        }
        value = kernel(x, rest, is_reduced);
    }
    value
}

/// tan(x + rest), or -1 / tan(x + rest) if the angle was reduced by pi/2; |x| <= pi/4.
#[portable]
pub fn kernel<R: Real>(x: R, rest: R, is_reduced: bool) -> R {
    let is_negative = x < R::ZERO;
    let magnitude = if is_negative { -x } else { x };
    let is_big = magnitude >= R::lit(BIG);
    let mut u = x;
    let mut y = rest;
    if is_big {
        let rest_of_magnitude = if is_negative { -rest } else { rest };
        u = (R::lit(QUARTER_PI) - magnitude) + (R::lit(QUARTER_PI_REST) - rest_of_magnitude);
        y = R::ZERO;
    }
    let r = beyond_first(u, y);
    let w = u + r;
    let mut value = w;
    if is_big {
        let s = if is_reduced { -R::ONE } else { R::ONE };
        let v = s - R::lit(2.0) * (u + (r - w * w / (w + s)));
        value = if is_negative { -v } else { v };
    } else if is_reduced {
        value = negative_reciprocal(u, r, w);
    }
    value
}

/// tan(x + y) - x by the polynomial, |x| <= [`BIG`].
#[portable]
pub fn beyond_first<R: Real>(x: R, y: R) -> R {
    let z = x * x;
    let w = z * z;
    let odd = R::lit(T1) + w * (R::lit(T3) + w * (R::lit(T5) + w * (R::lit(T7) + w * (R::lit(T9) + w * R::lit(T11)))));
    let even =
        z * (R::lit(T2) + w * (R::lit(T4) + w * (R::lit(T6) + w * (R::lit(T8) + w * (R::lit(T10) + w * R::lit(T12))))));
    let s = z * x;
    y + z * (s * (odd + even) + y) + s * R::lit(T0)
}

/// -1 / (x + r), w = x + r rounded, -0.8 < w < -1/8; -1 / w alone would be wrong by up to two units in the last place.
#[portable]
pub fn negative_reciprocal<R: Real>(x: R, r: R, w: R) -> R {
    let w0 = -leading(-w);
    let v = r - (w0 - x);
    let a = -R::ONE / w;
    let a0 = leading(a);
    a0 + a * (R::ONE + a0 * w0 + a0 * v)
}

/// The leading 21 bits of a magnitude, 1/8 <= magnitude < 8; the others are cut off.
#[portable]
pub fn leading<R: Real>(magnitude: R) -> R {
    // 2^-23: the unit of 21 bits from 1/8 to 1/4
    let mut unit = R::lit(1.192_092_895_507_812_5e-7);
    let octaves = [R::lit(0.25), R::lit(0.5), R::ONE, R::lit(2.0), R::lit(4.0)];
    for i in 0..5 {
        if magnitude >= octaves[i] {
            unit = unit + unit;
        }
    }
    // 1.5 * 2^52 units: a sum with it has no bit below the unit
    let shift = unit * R::lit(6_755_399_441_055_744.0);
    let nearest = (magnitude + shift) - shift;
    if nearest > magnitude { nearest - unit } else { nearest }
}
