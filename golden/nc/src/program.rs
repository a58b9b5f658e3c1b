//! What an NC program says, as plain data: nothing of how it is written, except the lines and the block numbers.

use std::fmt;

/// A program that has no mistake.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// behind `%` in the first line, without it
    pub name: Option<String>,
    /// in the order of the file; the last one is `M30`
    pub blocks: Vec<Block>,
}

/// What begins at the same time.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// line of the file, from 1
    pub line: usize,
    /// behind `N`
    pub number: Option<u32>,
    /// those of the spindle first
    pub commands: Vec<Command>,
}

/// One thing that a block asks for.
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
    /// G00, G01: absolute positions in the order of the words; the feed is there with G01, from this block or an earlier one
    Move { rapid: bool, axes: Vec<(Axis, f64)>, feed_mm_min: Option<f64> },
    /// M30
    End,
}

/// What a command acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// all axes of the program
    Axes,
    Axis(Axis),
    /// by its number: `S` and `S1` are 1
    Spindle(u32),
}

/// An axis of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Axis {
    X,
    Y,
    Z,
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::X => "X",
            Self::Y => "Y",
            Self::Z => "Z",
        })
    }
}

/// Which way a spindle turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// M3, towards growing positions
    Positive,
    /// M4
    Negative,
}
