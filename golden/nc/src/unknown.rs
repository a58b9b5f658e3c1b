//! A word that is none: what is said of it, and which word was probably meant. Nothing of what words say.

use super::bracket;
use super::lexical::Piece;
use super::mistake::{Mistakes, shown};
use super::number::{DECIMAL, decimal};
use super::word::parse;

const WORDS: &str = "`N`, `G00`, `G01`, `G04`, `G74`, `G135`, `G136`, `G137`, `M3`, `M4`, `M5`, `M19`, `M30`, `S`, `S.POS=`, `S[ ]`, `F`, `X`, `Y`, `Z`";

/// What some write for a word.
const ALIASES: [(&str, &str); 8] = [
    ("G0", "G00"),
    ("G1", "G01"),
    ("G4", "G04"),
    ("M03", "M3"),
    ("M04", "M4"),
    ("M05", "M5"),
    ("SPOS=", "S.POS="),
    ("S=", "S"),
];

/// Says what is wrong with a word that is none.
pub(crate) fn say(piece: Piece<'_>, mistakes: &mut Mistakes) {
    let Piece { column, text } = piece;
    let found = shown(text);
    if let Some((allowed, instead)) = meant(text) {
        mistakes.push(column, found, allowed, instead);
    } else if text.contains('[') {
        bracket::read(piece, mistakes);
    } else if text.starts_with('%') {
        mistakes.push(column, found, "`%` and the name of the program before the first block, once", "nothing here");
    } else if text.starts_with("G136=") {
        mistakes.push(column, found, "`G136` and axes, or `G136=` in brackets", "`G136 X80` or `S[G136=80]`");
    } else if text.contains(".POS") {
        let allowed = "`S.POS=` and an angle in deg, for spindle 1 only";
        mistakes.push(column, found, allowed, "a word like `S.POS=180`");
    } else if decimal(text).is_some() {
        mistakes.push(column, found, "a letter before each number", "the letter, as in `G04 X2.5`");
    } else if let Some((word, allowed)) = bad_number(text) {
        mistakes.push(column, found, allowed, format!("`{word}` and such a number"));
    } else {
        mistakes.push(column, found, WORDS, "one of these words, or nothing");
    }
}

/// What is allowed, and the words that were probably meant.
fn meant(text: &str) -> Option<(&'static str, String)> {
    const LONGEST: usize = 200; // no suggestion is worth more of a line
    if text.len() > LONGEST {
        return None;
    }
    let upper = text.to_ascii_uppercase();
    let parts: Vec<String> = if upper.contains('[') { vec![upper] } else { apart(&upper).map(spelt).collect() };
    let known = parts.iter().all(|part| parse(part).is_some());
    let allowed = match parts.len() {
        1 if parts[0].eq_ignore_ascii_case(text) => "words in upper case",
        1 => "one spelling of a word",
        _ => "words with blanks between them",
    };
    known.then(|| (allowed, format!("`{}`", parts.join(" "))))
}

/// The text, cut where a letter follows a digit.
fn apart(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let pairs = rest.bytes().zip(rest.bytes().skip(1));
        let cut = pairs.enumerate().find(|(_, (one, next))| one.is_ascii_digit() && next.is_ascii_alphabetic());
        let (part, behind) = rest.split_at(cut.map_or(rest.len(), |(at, _)| at + 1));
        rest = behind;
        (!part.is_empty()).then_some(part)
    })
}

/// The word as it is read here, if some write it another way.
fn spelt(part: &str) -> String {
    let whole = ALIASES.iter().find(|(alias, _)| *alias == part).map(|(_, word)| (*word).to_owned());
    let start = ALIASES.iter().filter(|(alias, _)| alias.ends_with('='));
    let start = start.filter_map(|(alias, word)| part.strip_prefix(alias).map(|rest| format!("{word}{rest}"))).next();
    whole.or(start).unwrap_or_else(|| part.to_owned())
}

/// A word that has its letter and a number that is none for it: the letter, and what is allowed.
fn bad_number(text: &str) -> Option<(&'static str, &'static str)> {
    const NUMBERS: [(&str, &str); 6] = [
        ("N", "a block number of up to 9 digits"),
        ("S", "a speed in rpm, no less than 0, with up to 9 digits before the point and up to 6 behind it"),
        ("F", "a feed in mm/min above 0, with up to 9 digits before the point and up to 6 behind it"),
        ("X", DECIMAL),
        ("Y", DECIMAL),
        ("Z", DECIMAL),
    ];
    let digit = |rest: &str| rest.is_empty() || rest.starts_with(|first: char| "+-.=0123456789".contains(first));
    NUMBERS.iter().find(|(word, _)| text.strip_prefix(word).is_some_and(digit)).copied()
}
