//! The check word of a parameter set (docs/parameter-sets.md, "The check word") in whole numbers: every real is the integer
//! that it is in units of its last piece. No rule about a number is here.

/// The places of the two polynomials, and their modulus.
const PLACES: [i64; 2] = [31_337, 17_389];
const MODULUS: i64 = 46_337;

/// Bits of a piece.
const BITS: u32 = 31;

/// The pieces of a real of at most 32768, the largest first, and whether digits below the last one are left over.
fn pieces(real: f64, single: bool) -> (Vec<i64>, bool) {
    let count: u32 = if single { 3 } else { 4 };
    // Units of 2^-places: number * 2^15 is the first piece, every further one 2^31 below it.
    let places = 15 + BITS * (count - 1);
    let bits = real.to_bits();
    let exponent = i32::try_from(bits >> 52 & 0x7ff).expect("11 bits");
    let fraction = i128::from(bits & ((1 << 52) - 1));
    let digits = if exponent == 0 { fraction } else { fraction | 1 << 52 };
    // real = digits * 2^(exponent - 1075)
    let shift = exponent.max(1) - 1075 + i32::try_from(places).expect("at most 108");
    let down = u32::try_from(-shift).unwrap_or(0).min(127);
    let up = u32::try_from(shift).unwrap_or(0);
    assert!(up <= 71, "model: {real} is above what a set may have");
    let units = digits << up >> down;
    let is_left_over = units << down >> up != digits;
    let sign = if real.is_sign_negative() { -1 } else { 1 };
    let piece = |place: u32| {
        let above = units >> (BITS * (count - 1 - place));
        let of_place = if place == 0 { above } else { above & ((1 << BITS) - 1) };
        sign * i64::try_from(of_place).expect("31 bits")
    };
    ((0..count).map(piece).collect(), is_left_over)
}

/// The word of these reals in a set of that structure, and whether it covers all of their digits: nothing is left over.
/// Remainders have the sign of what is divided.
#[must_use]
pub fn word(structure: u32, reals: impl IntoIterator<Item = f64>, single: bool) -> (u32, bool) {
    let structure = i64::from(structure);
    let (mut word, mut is_left_over) = ([structure % MODULUS, structure / MODULUS], false);
    for real in reals {
        let (pieces, is_one_left_over) = pieces(real, single);
        is_left_over |= is_one_left_over;
        for piece in pieces {
            for (value, place) in word.iter_mut().zip(PLACES) {
                *value = (*value * place + piece % MODULUS) % MODULUS;
            }
        }
    }
    let [first, second] = word.map(|value| value.rem_euclid(MODULUS));
    (u32::try_from((1 + first) * MODULUS + second).expect("32 bits"), !is_left_over)
}
