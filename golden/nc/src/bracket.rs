//! The contents of a spindle's brackets, `S[...]` and `S2[...]`: the commands of one bracket. No other spindle word.

use super::lexical::Piece;
use super::mistake::{Mistakes, shown};
use super::number;
use super::program::{Command, Target};

/// A bracket with at least one command.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bracket {
    pub(crate) spindle: u32,
    pub(crate) commands: Vec<Command>,
}

const WORDS: &str = "`G135`, `G136=` and a percentage, both of them, `G137`, `G74`, `PUTAX`";

/// Reads a bracket; `None` after a reported error.
pub(crate) fn read(piece: Piece<'_>, mistakes: &mut Mistakes) -> Option<Bracket> {
    let (name, after) = piece.text.split_once('[')?;
    let Some(spindle) = spindle(name) else {
        let allowed = "a spindle before `[`: `S`, or `S1` to `S99`";
        mistakes.push(piece.column, shown(piece.text), allowed, "a bracket like `S[G135]` or `S2[G135]`");
        return None;
    };
    let Some((inside, _)) = after.split_once(']') else {
        mistakes.push(piece.column, format!("{} without its end", shown(piece.text)), "a bracket in one line", "`]`");
        return None;
    };
    let said = mistakes.count();
    let mut commands = Vec::new();
    for word in words(inside, piece.column + name.len() + 1) {
        let Some(command) = known(spindle, &word.text.to_ascii_uppercase()) else {
            unknown(word, mistakes);
            continue;
        };
        if commands.iter().any(|other| !go_together(other, &command)) {
            let found = format!("{} with another word of the bracket", shown(word.text));
            mistakes.push(word.column, found, WORDS, format!("`{name}[{}]` in a block of its own", word.text));
        }
        commands.push(command);
    }
    if commands.is_empty() && mistakes.count() == said {
        mistakes.push(piece.column, format!("{} without a word", shown(piece.text)), WORDS, "one of them");
    }
    (mistakes.count() == said).then_some(Bracket { spindle, commands })
}

/// `S`, `S1` .. `S99`
fn spindle(name: &str) -> Option<u32> {
    let digits = name.strip_prefix(['S', 's'])?;
    if digits.is_empty() {
        return Some(1);
    }
    number::count(digits).filter(|number| (1..=99).contains(number) && !digits.starts_with('0'))
}

/// The words between blanks.
fn words(inside: &str, column: usize) -> impl Iterator<Item = Piece<'_>> {
    let mut at = column;
    inside.split([' ', '\t']).filter_map(move |text| {
        let word = Piece { column: at, text };
        // A bracket contains only ASCII words: a byte is a character.
        at += text.len() + 1;
        (!text.is_empty()).then_some(word)
    })
}

/// Reports the error in a text that is not a word.
fn unknown(word: Piece<'_>, mistakes: &mut Mistakes) {
    let Piece { column, text } = word;
    let found = shown(text);
    let upper = text.to_ascii_uppercase();
    if upper == "G136" {
        mistakes.push(column, found, "`G136=` and a percentage in brackets", "a word like `G136=80`");
    } else if upper.starts_with("G136=") {
        mistakes.push(column, found, number::INTEGER, "`G136=` and such a number");
    } else {
        mistakes.push(column, format!("{found} in a bracket"), WORDS, "one of them");
    }
}

fn known(spindle: u32, text: &str) -> Option<Command> {
    let target = Target::Spindle(spindle);
    match text {
        "G135" => Some(Command::Feedforward { target, on: true }),
        "G137" => Some(Command::Feedforward { target, on: false }),
        "G74" => Some(Command::Home { target }),
        "PUTAX" => Some(Command::Release { spindle }),
        _ => {
            let percent = text.strip_prefix("G136=").and_then(number::integer)?;
            Some(Command::Percentage { target, percent })
        }
    }
}

/// Whether two commands may stand in one bracket: the selection and its percentage.
fn go_together(one: &Command, other: &Command) -> bool {
    matches!(
        (one, other),
        (Command::Feedforward { on: true, .. }, Command::Percentage { .. })
            | (Command::Percentage { .. }, Command::Feedforward { on: true, .. })
    )
}
