//! Words and lines that the reader skips: one note for each kind, with its first place and the count.

use std::collections::BTreeMap;

/// A kind of words or lines that are skipped, or interpreted in one of several meanings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PassedKind {
    /// T, D, H, M6, G40, G43, G44, G49: lengths and radii of tools
    Tool,
    /// M0, M1, M7 to M9 and the other M words that no other kind has
    Machine,
    /// planes, feed in mm/min, program numbers, messages: settings that the scenario already has or does not need
    Setting,
    /// G09, G60, G61, G64, #SLOPE and similar: smoothing of a path
    PathMode,
    /// G54 to G59
    Offset,
    /// blocks with G28, G30, G53
    MachinePosition,
    /// blocks with `/`
    Skip,
    /// G04 with P, an integer
    DwellUnit,
    /// G92 with axes: the present position gets another number
    Preset,
    /// G01 before any F
    NoFeed,
    /// no M30, no M2
    NoEnd,
    /// lines after M30
    AfterEnd,
}

/// The skipped words of one kind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Passed {
    pub kind: PassedKind,
    /// the first one's line, from 1
    pub line: usize,
    /// character of the first one in its line, from 1
    pub column: usize,
    /// the words, each once, in the order of the file; only the first ones of many
    pub words: Vec<String>,
    /// their number
    pub count: usize,
}

/// The skipped words, as they are found.
#[derive(Default)]
pub(crate) struct PassedOver(BTreeMap<PassedKind, Passed>);

impl PassedOver {
    pub(crate) fn push(&mut self, kind: PassedKind, line: usize, column: usize, word: &str) {
        const MOST: usize = 8;
        let first = || Passed { kind, line, column, words: Vec::new(), count: 0 };
        let passed = self.0.entry(kind).or_insert_with(first);
        passed.count += 1;
        if passed.words.len() < MOST && !word.is_empty() && passed.words.iter().all(|other| other != word) {
            passed.words.push(word.to_owned());
        }
    }

    /// All kinds, in the order of their first places.
    pub(crate) fn sorted(self) -> Vec<Passed> {
        let mut all: Vec<Passed> = self.0.into_values().collect();
        all.sort_by_key(|passed| (passed.line, passed.column, passed.kind));
        all
    }
}
