//! The check word of a parameter set, which is the number of the set. A block recomputes it before it uses a set. It is formed
//! with arithmetic only, without access to bits, so that every language computes the same word.
//!
//! Each number is split exactly into integers of 31 bits, without a remainder. The integers are the coefficients of two
//! polynomials modulo a prime, which start with the structure of the set.
//!
//! ```text
//! first  = structure mod 46337 ;  second = structure / 46337
//! rest   = number * 2^15
//! piece  = whole part of rest ;  rest = (rest - piece) * 2^31       three times in single, four times in double precision
//! first  = (first * 31337 + piece) mod 46337 ;  second = (second * 17389 + piece) mod 46337
//! word   = 46337 + first * 46337 + second                           after the last number; mod from 0 on
//! ```
//!
//! A change of one number always changes the word, except a change of the sign of 0. Any other change, such as a mix of two
//! sets, is missed with a probability of 1 in 2e9. 46337 is the largest prime whose square fits in an `i32`. A word is never 0.

use crate::precision::is_single;
use portable::{Real, from_i32, in_range, note, portable, truncate, unsigned};

/// A check word that is being formed, a piece at a time.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Forming<R> {
    /// check word: the pieces as a polynomial at 31337, modulo 46337
    pub first: i32,
    /// check word: the pieces as a polynomial at 17389, modulo 46337
    pub second: i32,
    /// pieces of the number whose turn it is that the check word contains
    pub pieces: u32,
    /// what is left of that number after these pieces, scaled
    pub rest: R,
    /// whether the word covers every digit so far: a number that is smaller than any coefficient has more
    pub is_covering: bool,
}

constants! {
    /// largest magnitude of a number of a parameter set, limits scaled by 2^-20
    pub fn largest_number<R: Real>() -> R { R::lit(32_768.0) }
    /// 2^15: scales a number before its first integer for the check word is taken
    pub fn first_cut<R: Real>() -> R { R::lit(32_768.0) }
    /// 2^31: scales the remainder of a number before its next integer for the check word is taken
    pub fn next_cut<R: Real>() -> R { R::lit(2_147_483_648.0) }
    /// largest number below 2^31: upper bound of a scaled number from which an integer for the check word is taken
    pub fn largest_piece<R: Real>() -> R { R::per_kind(2_147_483_647.999_999_8, 2_147_483_520.0) }
    /// 2^-20: scales a limit for the check word
    pub fn limit_scale<R: Real>() -> R { R::lit(9.536_743_164_062_5e-7) }
    /// the last piece of a number, counted from 0
    pub fn last_piece<R: Real>() -> u32 { if is_single::<R>() { 2u32 } else { 3u32 } }
}

/// The whole part of a real below 2^31; 0 for any other.
#[portable]
pub fn whole<R: Real>(real: R) -> i32 {
    let mut piece = 0i32;
    if in_range(real, largest_piece()) {
        piece = truncate(real);
    } else {
        note("reached only if the block's memory was corrupted");
    }
    piece
}

/// The parts of the word of a structure, before the first number.
#[must_use]
pub fn empty(structure: u32) -> [i32; 2] {
    [structure % 46_337, structure / 46_337].map(u32::cast_signed)
}

/// Starts the word of a set, with the parts of its structure.
#[portable]
pub fn start<R: Real>(forming: &mut Forming<R>, first: i32, second: i32) {
    forming.first = first;
    forming.second = second;
    forming.pieces = 0u32;
    forming.is_covering = true;
}

/// A remainder as it is from 0 on.
#[portable]
pub fn positive(remainder: i32) -> i32 {
    if remainder < 0i32 { remainder + 46_337i32 } else { remainder }
}

/// Adds the next piece of a number of at most [`largest_number`]. Returns whether it was the last one.
#[portable]
pub fn add<R: Real>(forming: &mut Forming<R>, number: R) -> bool {
    let rest = if forming.pieces == 0u32 { number * first_cut() } else { forming.rest };
    let piece = whole(rest);
    forming.rest = (rest - from_i32::<R>(piece)) * next_cut();
    let part = positive(piece % 46_337i32);
    let first = forming.first % 46_337i32 * 31_337i32;
    let second = forming.second % 46_337i32 * 17_389i32;
    forming.first = (first + part) % 46_337i32;
    forming.second = (second + part) % 46_337i32;
    let is_complete = forming.pieces >= last_piece::<R>();
    if is_complete {
        forming.pieces = 0u32;
        forming.is_covering = forming.is_covering && in_range(forming.rest, R::ZERO);
    } else {
        forming.pieces += 1u32;
    }
    is_complete
}

/// Whether the word is the number of the set, and no number has digits that it does not cover.
#[portable]
pub fn is_word<R: Real>(forming: &Forming<R>, set_id: u32) -> bool {
    set_id == self::set_id(forming) && forming.is_covering
}

/// The word as the number of a set; 0 if the memory was corrupted.
#[portable]
pub fn set_id<R: Real>(forming: &Forming<R>) -> u32 {
    let upper = forming.first % 46_337i32 * 46_337i32;
    let lower = forming.second % 46_337i32 + 46_337i32;
    let word = upper + lower;
    let mut set_id = 0u32;
    if word >= 0i32 {
        set_id = unsigned(word);
    } else {
        note("reached only if the block's memory was corrupted");
    }
    set_id
}
