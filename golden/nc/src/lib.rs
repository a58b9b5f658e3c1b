//! NC programs, read strictly: the crate's parts and what other crates see of them. It knows no generator, no block and no file.
//!
//! ```text
//! program        what a program says: blocks and their commands
//! mistake        what is wrong, and where
//! number         the forms of numbers
//! lexical        a line -> words and comments
//! bracket        what stands in S[...]; word: a word -> what it says; unknown: what is said of one that is none
//! spindle, axes  words of a block -> commands; block: what the words of a block may be beside each other
//! read           lines -> a program
//! ```
//!
//! # The language
//!
//! A line is a block: words with blanks between them, in any order, the block number first. `( )` is a comment; it ends with its line
//! at the latest. The first line with a word may be `%` and the name of the program. Every program ends with `M30`.
//!
//! | words | what they say |
//! | --- | --- |
//! | `G135`, `G137` | feedforward of all axes on, off |
//! | `G136 X80 Y0` | its percentages, integers; also beside `G135` |
//! | `S[G135]`, `S[G136=80]`, `S2[G135 G136=90]`, `S[G137]` | the same of a spindle; `S` is spindle 1 |
//! | `S[PUTAX]` | the spindle becomes an axis |
//! | `G74 X1 Y1`, `S[G74]` | homing of axes, all at once, or of a spindle |
//! | `M3 S1000`, `M4 S1000`, `S500`, `M5` | spindle 1 turns, takes another speed [rpm] in the direction in force, stops |
//! | `M19 S.POS=180 S500 M4` | spindle 1 goes to an angle [deg]; speed [rpm] and direction need not be there |
//! | `G00 X1 Y2`, `G01 X1 F600` | the axes go to a position [mm], rapidly or with a feed [mm/min] |
//! | `G04 X2.5` | dwell [s], alone in its block |
//! | `M30` | end, alone in its block |
//!
//! What manuals leave open is refused here, or settled:
//! - `G00` and `G01` are said in each block that moves; F stays in force.
//! - The number behind an axis of `G74` is its turn in a sequence; only 1 is allowed. Axes that come later stand in a later block.
//! - M5, M19, `S[G74]` and `S[PUTAX]` end the direction in force: an S word alone is refused after them. The S word of `M19` counts
//!   for the positioning only: `M3` and `M4` always have their own.
//! - A bracket is the only spindle word of its block.
//! - Percentages are kept as written: the block that uses them limits them to 0..100.
//! - The commands of a block are in a fixed order, those of the spindle first.
#![forbid(unsafe_code)]

mod axes;
mod block;
mod bracket;
mod foreign;
mod lexical;
mod mistake;
mod number;
mod passed;
mod program;
mod read;
mod spindle;
mod unknown;
mod word;

pub use mistake::Mistake;
pub use passed::{Kind, Passed};
pub use program::{Axis, Block, Command, Direction, Program, Target};
pub use read::read;
