//! What a program says and the reader does not act on: one note for each kind, with its first place and the number of them.

use std::collections::BTreeMap;

/// A kind of words, or of lines, that are passed over or taken in one of several meanings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PassedKind {
    /// T, D, H, M6, G40, G43, G44, G49: lengths and radii of tools
    Tool,
    /// M0, M1, M7 to M9 and the other M words that no other kind has
    Machine,
    /// planes, feed in mm/min, program numbers, messages: what the scenario has anyway, or does not need
    Setting,
    /// G09, G60, G61, G64, #SLOPE and the like: how a path is smoothed
    PathMode,
    /// G54 to G59
    Offset,
    /// blocks with G28, G30, G53
    MachinePosition,
    /// blocks with `/`
    Skip,
    /// G04 with P, an integer
    DwellUnit,
    /// G92 with axes: where they are gets another number
    Preset,
    /// G01 before any F
    NoFeed,
    /// no M30, no M2
    NoEnd,
    /// lines after M30
    AfterEnd,
}

/// What was passed over of one kind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Passed {
    pub kind: PassedKind,
    /// the first one's line, from 1
    pub line: usize,
    /// the first one's character of the line, from 1
    pub column: usize,
    /// the words, each once, in the order of the file; of many the first ones
    pub words: Vec<String>,
    /// how many there are
    pub count: usize,
}

/// What is passed over, as it is found.
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
