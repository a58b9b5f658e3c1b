//! The check word of a parameter set: what a block forms anew before it takes a set over. No bit is read, so that every language forms
//! the same word.
//!
//! Each number is cut into integers of 31 bits, exactly: nothing of it is left over. The integers are the coefficients of a polynomial,
//! whose values at two places, modulo a prime, are the word.
//!
//! ```text
//! rest  = number * 2^15
//! piece = whole part of rest ;  rest = (rest - piece) * 2^31       three times in single, four times in double precision
//! first = (first * 31337 + piece) mod 46337 ;  second = (second * 17389 + piece) mod 46337
//! ```
//!
//! A number that has changed always changes the word, unless it is 0 and only its sign has. Of other changes, numbers of several sets in
//! one among them, one in 2e9 does not. 46337 is the largest prime whose square an `i32` holds.

#![expect(clippy::needless_range_loop, reason = "the portable subset has one way to go through an array")]

use crate::precision::is_single;
use portable::{Real, from_i32, in_range, note, portable, truncate};

/// The check word.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Word {
    /// check word: the numbers as a polynomial at 31337, modulo 46337
    pub first: i32,
    /// check word: the same at 17389
    pub second: i32,
}

/// A check word that is being formed.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Forming<R> {
    /// so far
    pub word: Word,
    /// what was left over of all numbers: 0, unless one is smaller than any coefficient
    pub left_over: R,
}

/// Integers that a number is cut into, at most.
pub const PIECES: usize = 4;

/// largest magnitude of a number of a parameter set, limits scaled
#[portable]
pub fn largest_number<R: Real>() -> R {
    R::lit(32_768.0)
}

/// 2^15: the first cut
#[portable]
pub fn first_cut<R: Real>() -> R {
    R::lit(32_768.0)
}

/// 2^31: each further cut
#[portable]
pub fn next_cut<R: Real>() -> R {
    R::lit(2_147_483_648.0)
}

/// the largest number below 2^31: what is left of a number is below it after each cut
#[portable]
pub fn largest_piece<R: Real>() -> R {
    R::per_kind(2_147_483_647.999_999_8, 2_147_483_520.0)
}

/// 2^-20: factor of a limit before it is cut
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
                note("only what something else has overwritten comes here");
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
