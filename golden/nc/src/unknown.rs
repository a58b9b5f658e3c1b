//! The report for a text that is not a word. Nothing about the meaning of words.

use super::bracket;
use super::foreign::{self, Foreign};
use super::lexical::Piece;
use super::mistake::{Mistakes, shown};
use super::number::{DECIMAL, decimal};

/// Reports the error in a text that is not a word.
pub(crate) fn say(piece: Piece<'_>, mistakes: &mut Mistakes) {
    let Piece { column, text } = piece;
    let found = shown(text);
    let upper = text.to_ascii_uppercase();
    let kind = foreign::text(&upper);
    if upper.starts_with("G136=") {
        mistakes.push(column, found, "`G136` and axes, or `G136=` in brackets", "`G136 X80` or `S[G136=80]`");
    } else if upper.starts_with('S')
        && upper.contains('[')
        && !upper[1..].starts_with(|first: char| first.is_alphabetic())
    {
        bracket::read(piece, mistakes);
    } else if upper.starts_with('%') && kind != Foreign::Subprogram {
        mistakes.push(column, found, "`%` and the name of the program before the first block, once", "nothing here");
    } else if text.starts_with(')') {
        mistakes.push(column, found + " without its beginning", "comments in `( )`", "`(` before the comment");
    } else if upper.contains(".POS") {
        let allowed = "`S.POS=` and an angle in deg, for spindle 1 only";
        mistakes.push(column, found, allowed, "a word like `S.POS=180`");
    } else if kind != Foreign::Unknown && !upper.starts_with("#TIME") {
        mistakes.foreign(column, text, kind);
    } else if decimal(text).is_some() {
        mistakes.push(column, found, "a letter before each number", "the letter, as in `G04 X2.5`");
    } else if let Some((word, allowed)) = bad_number(&upper) {
        mistakes.push(column, found, allowed, format!("`{word}` and such a number"));
    } else {
        mistakes.foreign(column, text, Foreign::Unknown);
    }
}

/// A word with a known letter and an invalid number: the letter, and what is allowed.
fn bad_number(upper: &str) -> Option<(&str, &'static str)> {
    let word = if upper.starts_with("#TIME") { "#TIME" } else { upper.get(..1)? };
    let allowed = match word {
        "N" => "a block number of up to 9 digits",
        "G" | "M" => "the number of the function, without a sign",
        "S" => "a speed in rpm, no less than 0, with up to 9 digits before the point and up to 30 after it",
        "F" => "a feed above 0, with up to 9 digits before the point and up to 30 after it",
        "O" | ":" => "the number of the program, with up to 9 digits",
        "#TIME" => "a time in s, no less than 0",
        "X" | "Y" | "Z" | "A" | "B" | "C" | "U" | "V" | "W" | "E" | "T" | "D" | "H" | "P" | "Q" | "R" | "L" | "I"
        | "J" | "K" => DECIMAL,
        _ => return None,
    };
    let is_number =
        |rest: &str| rest.is_empty() || rest.trim_start().starts_with(|first: char| "+-.,=0123456789".contains(first));
    is_number(&upper[word.len()..]).then_some((word, allowed))
}
