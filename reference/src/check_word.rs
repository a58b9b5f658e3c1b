//! The check word of a parameter set. A block recomputes it before it uses a set. It is formed with arithmetic only, without
//! access to bits, so that every language computes the same word.
//!
//! Each number is split exactly into integers of 31 bits, without a remainder. The integers are the coefficients of a
//! polynomial. Its values at two points, modulo a prime, are the word.
//!
//! ```text
//! rest  = number * 2^15
//! piece = whole part of rest ;  rest = (rest - piece) * 2^31       three times in single, four times in double precision
//! first = (first * 31337 + piece) mod 46337 ;  second = (second * 17389 + piece) mod 46337
//! ```
//!
//! A change of one number always changes the word, except a change of the sign of 0. Any other change, such as a mix of two
//! sets, is missed with a probability of 1 in 2e9. 46337 is the largest prime whose square fits in an `i32`.

#![expect(clippy::needless_range_loop, reason = "the portable subset has one way to go through an array")]

use crate::precision::is_single;
use portable::{Real, from_i32, in_range, note, portable, truncate};

/// The check word.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Word {
    /// check word: the numbers as a polynomial at 31337, modulo 46337
    pub first: i32,
    /// check word: the numbers as a polynomial at 17389, modulo 46337
    pub second: i32,
}

/// A check word that is being formed.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Forming<R> {
    /// so far
    pub word: Word,
    /// sum of the remainders of all numbers: 0, unless a number is smaller than any coefficient
    pub left_over: R,
}

/// Largest number of integers that a number is split into.
pub const PIECES: usize = 4;

/// largest magnitude of a number of a parameter set, limits scaled by 2^-20
#[portable]
pub fn largest_number<R: Real>() -> R {
    R::lit(32_768.0)
}

/// 2^15: scales a number before its first integer for the check word is taken
#[portable]
pub fn first_cut<R: Real>() -> R {
    R::lit(32_768.0)
}

/// 2^31: scales the remainder of a number before its next integer for the check word is taken
#[portable]
pub fn next_cut<R: Real>() -> R {
    R::lit(2_147_483_648.0)
}

/// largest number below 2^31: upper bound of a scaled number from which an integer for the check word is taken
#[portable]
pub fn largest_piece<R: Real>() -> R {
    R::per_kind(2_147_483_647.999_999_8, 2_147_483_520.0)
}

/// 2^-20: scales a limit for the check word
#[portable]
pub fn limit_scale<R: Real>() -> R {
    R::lit(9.536_743_164_062_5e-7)
}

/// Adds an integer.
#[portable]
pub fn add_piece(word: &mut Word, piece: i32) {
    let part = piece % 46_337i32;
    word.first = (word.first * 31_337i32 + part) % 46_337i32;
    word.second = (word.second * 17_389i32 + part) % 46_337i32;
}

/// Adds a number of at most [`largest_number`].
#[portable]
pub fn add<R: Real>(forming: &mut Forming<R>, number: R) {
    let mut rest = number * first_cut();
    for i in 0..PIECES {
        if i < 3usize || !is_single::<R>() {
            let mut piece = 0i32;
            if in_range(rest, largest_piece()) {
                piece = truncate(rest);
            } else {
                note("reached only if the block's memory was corrupted");
            }
            add_piece(&mut forming.word, piece);
            rest = (rest - from_i32::<R>(piece)) * next_cut();
        }
    }
    forming.left_over = forming.left_over + rest;
}

/// Adds three numbers.
#[portable]
pub fn add_three<R: Real>(forming: &mut Forming<R>, numbers: &[R; 3]) {
    for i in 0..3 {
        add(forming, numbers[i]);
    }
}
