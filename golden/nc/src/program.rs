//! The contents of an NC program as plain data: nothing about its notation, except the lines and the block numbers.

use super::passed::Passed;
use std::fmt;

/// A program without errors.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// the text after `%` in the first line
    pub name: Option<String>,
    /// in the order of the file, without blocks that have no command; the last one is the end
    pub blocks: Vec<Block>,
    /// the skipped words, one entry per kind
    pub passed: Vec<Passed>,
}

/// Commands that begin at the same time.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// line of the file, from 1
    pub line: usize,
    /// the number after `N`
    pub number: Option<u32>,
    /// commands of the spindle first
    pub commands: Vec<Command>,
}

/// One command of a block.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// G135, G137
    Feedforward { target: Target, on: bool },
    /// G136, in %, as written
    Percentage { target: Target, percent: i32 },
    /// M3, M4, or an S word alone
    Turn { spindle: u32, direction: Direction, rpm: f64 },
    /// M5
    Stop { spindle: u32 },
    /// M19, with the angle of S.POS
    Position { spindle: u32, direction: Option<Direction>, rpm: Option<f64>, degrees: f64 },
    /// G74
    Home { target: Target },
    /// S[PUTAX]
    Release { spindle: u32 },
    /// G04
    Dwell { seconds: f64 },
    /// G00, G01: absolute positions [mm, deg] in the order of the words; the feed of G01 is from this block or an earlier
    /// one, if there is any
    Move { rapid: bool, axes: Vec<(Axis, f64)>, feed_mm_min: Option<f64> },
    /// M30, M2, or the end of the file
    End,
}

/// The target of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// all axes of the program
    Axes,
    Axis(Axis),
    /// by its number: `S` and `S1` are 1
    Spindle(u32),
}

/// An axis of the program: `X`, or `X1` as in `X1=50`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Axis {
    letter: char,
    number: Option<u8>,
}

impl Axis {
    pub const X: Self = Self { letter: 'X', number: None };
    pub const Y: Self = Self { letter: 'Y', number: None };
    pub const Z: Self = Self { letter: 'Z', number: None };

    /// A letter of an axis, optionally with a number from 0 to 99 without leading zeros; in any case.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let letter = name.chars().next()?.to_ascii_uppercase();
        let digits = name.get(1..).filter(|_| "XYZABCUVWE".contains(letter))?;
        let is_plain = digits.bytes().all(|byte| byte.is_ascii_digit()) && (digits == "0" || !digits.starts_with('0'));
        let number = digits.parse().ok().filter(|number| *number < 100);
        (digits.is_empty() || is_plain && number.is_some()).then_some(Self { letter, number })
    }

    /// The axis of the same letter without a number.
    #[must_use]
    pub fn without_number(self) -> Self {
        Self { number: None, ..self }
    }

    /// Whether the feed applies to it: X, Y and Z form the path, the other axes follow.
    #[must_use]
    pub fn is_of_path(self) -> bool {
        matches!(self.letter, 'X' | 'Y' | 'Z')
    }

    /// Whether its positions are lengths, so that inches apply to it.
    pub(crate) fn is_linear(self) -> bool {
        !matches!(self.letter, 'A' | 'B' | 'C')
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.letter)?;
        self.number.map_or(Ok(()), |number| write!(f, "{number}"))
    }
}

/// The direction of a spindle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// M3, towards growing positions
    Positive,
    /// M4
    Negative,
}
