//! NC programs: the crate's parts and its public interface. It knows no generator, no block and no file.
//!
//! # The language
//!
//! A line is a block: words in any order, in upper or lower case, with or without blanks between them, the block number first.
//! Comments are `( )`, `;` and `//` to the end of the line, `# ` with a blank, and `#COMMENT BEGIN` to `#COMMENT END`. The
//! first line with a word may be `%`, with the name of the program.
//!
//! | words | meaning |
//! | --- | --- |
//! | `G135`, `G137` | feedforward of all axes on, off |
//! | `G136 X80 Y0` | its percentages, integers; also with `G135` |
//! | `S[G135]`, `S[G136=80]`, `S2[G135 G136=90]`, `S[G137]` | feedforward of a spindle; `S` is spindle 1 |
//! | `S[PUTAX]` | the spindle becomes an axis |
//! | `G74 X1 Y1`, `S[G74]` | homing of axes, all at once, or of a spindle |
//! | `M3 S1000`, `M4`, `S500`, `M5` | spindle 1 turns, takes another speed [rpm] in the direction in force, stops |
//! | `M19 S.POS=180 S500 M4` | spindle 1 goes to an angle [deg]; speed [rpm] and direction are optional |
//! | `G0 X1 Y2`, `G1 X1 F600`, `X2` | the axes go to a position [mm, deg], rapidly or with a feed [mm/min] |
//! | `G90`, `G91`; `G20`, `G70`, `G21`, `G71`; `G92 X0` | positions are absolute, incremental; inches, mm; the
//! position gets another number |
//! | `G4 X2.5`, `G4 F2`, `G4 P1.5`, `#TIME 2` | dwell [s] |
//! | `M30`, `M2` | end |
//!
//! What controllers do differently is settled here, or noted in the program ([`PassedKind`]):
//! - The number after an axis of `G74` is its turn in a sequence; only 1 is allowed. Axes that come later stand in a later
//!   block.
//! - M5, M19, `S[G74]` and `S[PUTAX]` end the direction in force. S stays in force for a later `M3` or `M4`; the S word of
//!   `M19` counts for the positioning only.
//! - A bracket is the only spindle word of its block.
//! - Percentages are kept as written: the block that uses them limits them to 0..100.
//! - The commands of a block are in a fixed order, those of the spindle first.
//! - A word that is neither read nor skipped is refused, with one message for all equal words.
#![forbid(unsafe_code)]

mod axes;
mod block;
mod bracket;
mod dwell;
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
pub use passed::{Passed, PassedKind};
pub use program::{Axis, Block, Command, Direction, Program, Target};
pub use read::read;
