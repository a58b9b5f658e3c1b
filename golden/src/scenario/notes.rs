//! Differences between a scenario and its program: a note for each kind, with its first place and the count.

use generator::codes;
use nc::{Passed, PassedKind};

/// A warning about a program, or about a program on an axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// from the generator's list
    pub code: &'static str,
    /// line of the file, from 1, and character in the line; 0 for the whole
    pub line: usize,
    pub column: usize,
    pub found: String,
    /// what the user can do; empty if nothing is necessary
    pub instead: String,
}

impl Note {
    pub(super) fn new(code: &'static str, line: usize, found: impl Into<String>, instead: impl Into<String>) -> Self {
        Self { code, line, column: 1, found: found.into(), instead: instead.into() }
    }
}

/// The note about words that the reader has skipped.
pub(super) fn of(passed: &Passed) -> Note {
    let (code, instead) = match passed.kind {
        PassedKind::Tool | PassedKind::Machine | PassedKind::Setting => (codes::NC_PASSED, ""),
        PassedKind::PathMode => (codes::NC_PATH_MODE, ""),
        PassedKind::Offset => (codes::NC_OFFSET, "positions of the machine, if several offsets are used"),
        PassedKind::MachinePosition => (codes::NC_OFFSET, "`G74 X1`, or `G00` and the position"),
        PassedKind::Skip => (codes::NC_ASSUMED, "the program without them, if they are skipped on the machine"),
        PassedKind::DwellUnit => (codes::NC_ASSUMED, "`G04 X` and seconds"),
        PassedKind::Preset => {
            (codes::NC_ASSUMED, "positions without `G92`, if the controller adds its numbers to them")
        }
        PassedKind::NoFeed => (codes::NC_ASSUMED, "`F` and a feed in mm/min"),
        PassedKind::NoEnd => (codes::NC_ASSUMED, "`M30`"),
        PassedKind::AfterEnd => (codes::NC_ASSUMED, "a file of one program"),
    };
    Note { code, line: passed.line, column: passed.column, found: found(passed), instead: instead.to_owned() }
}

fn found(Passed { kind, words, count, .. }: &Passed) -> String {
    let (what, rest) = match kind {
        PassedKind::Tool => ("word", "of the tool passed over: its length and its radius are taken as 0"),
        PassedKind::Machine => ("word", "of the machine passed over: no time, no stop and no output of them"),
        PassedKind::Setting => ("word", "of settings passed over: they change nothing here"),
        PassedKind::PathMode => ("word", "of the path mode passed over: each block ends with a stop"),
        PassedKind::Offset => ("word", "of zero offsets passed over: all offsets are taken as 0"),
        PassedKind::MachinePosition => ("move", "to positions of the machine not made: they are unknown"),
        PassedKind::Skip => ("block", "with `/` run, as with the switch off"),
        PassedKind::DwellUnit => ("dwell", "with a time of unknown unit: taken as ms from 100 on, below as s"),
        PassedKind::Preset => ("block", "with `G92` taken as another number for the present position"),
        PassedKind::NoFeed => ("move", "with `G01` before any F: made with vb_max (P-AXIS-00212)"),
        PassedKind::NoEnd => return "a program without `M30` or `M2`: its end is the end of the file".to_owned(),
        PassedKind::AfterEnd => ("line", "after the end of the program not read"),
    };
    let listed = if words.is_empty() { String::new() } else { format!(" ({})", words.join(", ")) };
    format!("{}{listed} {rest}", counted(*count, what))
}

/// Things of one kind as they are found: the line of the first one, and their number.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counted {
    pub(super) line: usize,
    pub(super) count: usize,
}

impl Counted {
    pub(super) fn push(&mut self, line: usize) {
        if self.count == 0 {
            self.line = line;
        }
        self.count += 1;
    }

    /// The note, if anything was found.
    pub(super) fn note(self, code: &'static str, what: &str, rest: &str, instead: &str) -> Option<Note> {
        (self.count > 0).then(|| Note::new(code, self.line, counted(self.count, what) + rest, instead))
    }
}

/// `1 move`, `2 moves`.
fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}
