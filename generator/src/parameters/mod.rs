//! The description of a parameter: its kinds, ranges and words, as plain data. The declarations are in `table.rs`; no value
//! is here.

pub mod others;
mod table;
mod text;
pub mod words;

pub use table::Name;
pub(crate) use table::{FILTERS, STAGES, TABLE};
pub(crate) use text::{path_with, real_text, time_text};

#[derive(Debug)]
pub struct Parameter {
    /// the vendor's id; axgen's own keys have none
    pub id: Option<&'static str>,
    /// its path, with a letter for each index: `stage[i].filter[k].order`
    pub path: &'static str,
    /// older paths of the same parameter; an index that they lack is 0
    pub aliases: &'static [&'static str],
    /// paths that a manual misprints
    pub misprints: &'static [&'static str],
    /// the number of values of each index
    pub(crate) indices: &'static [u32],
    pub scope: Scope,
    pub(crate) kind: Kind,
    /// the vendor's data type, where the manuals print it: UNS16, SGN32, REAL64, BOOLEAN, STRING
    pub data_type: &'static str,
    pub unit: &'static str,
    /// the default, as a list would write it: one for all, or one for each value of the last index. It may be out of range;
    /// then the parameter must be given where it is used.
    pub default: &'static [&'static str],
    /// the first controller build with the parameter
    pub since: &'static str,
    /// the range in the manual, if it differs from the range used here
    pub printed: &'static str,
    /// for a whole number: the meaning of each of its few values, from 0 on
    pub(crate) numbers: &'static [&'static str],
    /// the drive types for which the manual lists it
    pub drives: &'static str,
    /// the axis types for which the manual lists it: T translatory, R rotary, S spindle
    pub axes: &'static str,
    /// the dimension in the manual for each axis type, in ASCII with um and deg
    pub dimension: &'static str,
    /// whether it is validated only where it is used: a real machine's list has it for functions that are not generated
    pub(crate) is_shared: bool,
    pub meaning: &'static str,
}

/// The files that may contain a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// in an axis list, and below an axis of a set: the vendor's parameters
    List,
    /// only below an axis of a set: axgen's own keys
    Axis,
    /// only at the top of a set: axgen's own keys
    Set,
}

/// `Words` are several different words of a few, `Flags` the bits of a number, each with a word. An `open` real range does
/// not include its ends. A duration is in ns.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    Word(&'static [Word]),
    Words(&'static [Word]),
    Flags(&'static [Word]),
    Integer { from: i64, to: i64 },
    Real { from: f64, to: f64, open: [bool; 2] },
    Duration { from: u64, to: u64 },
    Text,
}

#[derive(Debug, PartialEq, Eq)]
pub struct Word {
    /// the spelling that axgen writes
    pub name: &'static str,
    pub number: Option<u32>,
    /// further spellings
    pub also: &'static [&'static str],
}

/// A word as axgen writes it, a finite real number, a time in ns.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Word(&'static str),
    Words(Vec<&'static str>),
    Integer(i64),
    Real(f64),
    Duration(u64),
    Text(String),
}

impl Name {
    pub fn parameter(self) -> &'static Parameter {
        &TABLE[self as usize]
    }
}

impl Word {
    /// All spellings, the name first.
    pub(crate) fn spellings(&self) -> impl Iterator<Item = &'static str> {
        std::iter::once(&self.name).chain(self.also).copied()
    }

    /// Whether a text is one of its spellings, in any case.
    pub(crate) fn is_spelled(&self, text: &str) -> bool {
        self.spellings().any(|spelling| spelling.eq_ignore_ascii_case(text))
    }
}

impl Parameter {
    /// Whether its value may be, or contain, that word, in any case and spelling.
    pub fn takes(&self, text: &str) -> bool {
        match self.kind {
            Kind::Word(words) | Kind::Words(words) | Kind::Flags(words) => {
                words.iter().any(|word| word.is_spelled(text))
            }
            Kind::Integer { .. } | Kind::Real { .. } | Kind::Duration { .. } | Kind::Text => false,
        }
    }

    /// All paths: the path, then its aliases.
    pub(crate) fn paths(&self) -> impl Iterator<Item = &'static str> {
        std::iter::once(&self.path).chain(self.aliases).copied()
    }

    /// The last part of the path: `order`.
    pub(crate) fn short(&self) -> &'static str {
        self.path.rsplit('.').next().unwrap_or(self.path)
    }

    /// The default at these indices, as a list would write it; `None` if the parameter has no default.
    pub(crate) fn default_at(&self, index: [u32; 2]) -> Option<&'static str> {
        self.at(self.default, index).copied()
    }

    /// What holds at these indices: the values are for those of the last index, the last value for all others.
    pub(crate) fn at<'v, T>(&self, values: &'v [T], index: [u32; 2]) -> Option<&'v T> {
        let last = index[self.indices.len().saturating_sub(1)] as usize;
        values.get(last).or(values.last())
    }

    /// Whether the value lies within the range of the kind.
    pub(crate) fn contains(&self, value: &Value) -> bool {
        match (&self.kind, value) {
            (Kind::Integer { from, to }, Value::Integer(n)) => (from..=to).contains(&n),
            (Kind::Real { from, to, open: [above, below] }, Value::Real(x)) => {
                (from..=to).contains(&x) && !(*above && x <= from) && !(*below && x >= to)
            }
            (Kind::Duration { from, to }, Value::Duration(ns)) => (from..=to).contains(&ns),
            _ => true,
        }
    }
}
