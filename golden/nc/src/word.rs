//! A word: which there are, and what each says by itself. Nothing of what may stand beside it, and no messages.

use super::bracket::{self, Bracket};
use super::lexical::Piece;
use super::mistake::Mistakes;
use super::number;
use super::program::{Axis, Direction};

/// A word of a block.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Word<'t> {
    /// N
    Number(u32),
    /// a G word
    Function(Function),
    /// M3, M4
    Turn(Direction),
    /// M5
    Stop,
    /// M19
    Position,
    /// M30
    End,
    /// S, in rpm
    Speed(f64),
    /// S.POS=, in deg
    Angle(f64),
    /// S[...]
    Bracket(Bracket),
    /// F, in mm/min
    Feed(f64),
    /// X, Y, Z: what the number is, the function says
    Axis(Axis, &'t str),
}

/// A word and where it stands.
#[derive(Clone, Debug)]
pub(crate) struct Placed<'t> {
    /// character of the line, from 1
    pub(crate) column: usize,
    pub(crate) text: &'t str,
    pub(crate) word: Word<'t>,
}

/// What the axis words of a block are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Function {
    Rapid,
    Linear,
    Dwell,
    Home,
    FeedforwardOn,
    Percentage,
    FeedforwardOff,
}

/// What a word says, if it is one.
pub(crate) fn parse(text: &str) -> Option<Word<'_>> {
    Some(match text {
        "G00" => Word::Function(Function::Rapid),
        "G01" => Word::Function(Function::Linear),
        "G04" => Word::Function(Function::Dwell),
        "G74" => Word::Function(Function::Home),
        "G135" => Word::Function(Function::FeedforwardOn),
        "G136" => Word::Function(Function::Percentage),
        "G137" => Word::Function(Function::FeedforwardOff),
        "M3" => Word::Turn(Direction::Positive),
        "M4" => Word::Turn(Direction::Negative),
        "M5" => Word::Stop,
        "M19" => Word::Position,
        "M30" => Word::End,
        _ if text.contains('[') => Word::Bracket(bracket::read(Piece { column: 1, text }, &mut Mistakes::default())?),
        _ => return with_number(text),
    })
}

fn with_number(text: &str) -> Option<Word<'_>> {
    if let Some(angle) = text.strip_prefix("S.POS=") {
        return number::decimal(angle).map(Word::Angle);
    }
    let (letter, number) = (text.chars().next()?, text.get(1..)?);
    match letter {
        'N' => number::count(number).map(Word::Number),
        // The direction of a spindle is its M word, never a sign.
        'S' => number::decimal(number).filter(|speed| *speed >= 0.0).map(Word::Speed),
        'F' => number::decimal(number).filter(|feed| *feed > 0.0).map(Word::Feed),
        'X' => number::decimal(number).map(|_| Word::Axis(Axis::X, number)),
        'Y' => number::decimal(number).map(|_| Word::Axis(Axis::Y, number)),
        'Z' => number::decimal(number).map(|_| Word::Axis(Axis::Z, number)),
        _ => None,
    }
}
