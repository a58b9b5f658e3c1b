//! What a parameter is: its kinds, ranges and words, as plain data; the declarations are in `table.rs`, no value is here.

pub mod others;
mod table;
mod text;
pub mod words;

pub use table::Name;
pub(crate) use table::{FILTERS, STAGES, TABLE};
pub(crate) use text::{path_with, real_text, time_text};

#[derive(Debug)]
pub struct Parameter {
    /// the vendor's; a key of our own has none
    pub id: Option<&'static str>,
    /// where it stands, with a letter for each index: `stage[i].filter[k].order`
    pub path: &'static str,
    /// older paths of the same parameter; an index that they lack is 0
    pub aliases: &'static [&'static str],
    /// printed wrongly in a manual
    pub misprints: &'static [&'static str],
    /// how many values each index has
    pub(crate) indices: &'static [u32],
    pub scope: Scope,
    pub(crate) kind: Kind,
    /// the vendor's data type, where the manuals print it: UNS16, SGN32, REAL64, BOOLEAN, STRING
    pub data_type: &'static str,
    pub unit: &'static str,
    /// the value that holds when none is given, as a list would write it: one for all, or one for each value of the last
    /// index; it may lie outside the range, then the parameter must be given where it is used
    pub default: &'static [&'static str],
    /// the controller build that has it first
    pub since: &'static str,
    /// the range as the manual prints it, where that is not the range used here
    pub printed: &'static str,
    /// of a whole number: what each of its few values means, from 0 on
    pub(crate) numbers: &'static [&'static str],
    /// the drive types for which the manual prints it
    pub drives: &'static str,
    /// the axis types for which the manual prints it: T translatory, R rotary, S spindle
    pub axes: &'static str,
    /// the dimension that the manual prints for each axis type, in ASCII: um and deg for its signs
    pub dimension: &'static str,
    /// whether it is validated where it is used only: a real machine's list has it for functions that are not generated
    pub(crate) is_shared: bool,
    pub meaning: &'static str,
}

/// In which file a parameter may stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// in an axis list, and below an axis of a set: the vendor's parameters
    List,
    /// only below an axis of a set: keys of our own
    Axis,
    /// only at the top of a set: keys of our own
    Set,
}

/// `Words` are several different ones of a few, `Flags` the bits of a number, each with a word; the ends of a real range do not
/// belong to it where it is `open`; a duration is in ns.
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
    /// as we write it
    pub name: &'static str,
    pub number: Option<u32>,
    /// further spellings
    pub also: &'static [&'static str],
}

/// A word as we write it, a finite real number, a time in ns.
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
    /// The name first.
    pub(crate) fn spellings(&self) -> impl Iterator<Item = &'static str> {
        std::iter::once(&self.name).chain(self.also).copied()
    }

    /// Whether a text is one of its spellings, in any case.
    pub(crate) fn is_spelled(&self, text: &str) -> bool {
        self.spellings().any(|spelling| spelling.eq_ignore_ascii_case(text))
    }
}

impl Parameter {
    /// Whether its value may be, or have, that word; in any case, and in any spelling of it.
    pub fn takes(&self, text: &str) -> bool {
        match self.kind {
            Kind::Word(words) | Kind::Words(words) | Kind::Flags(words) => {
                words.iter().any(|word| word.is_spelled(text))
            }
            Kind::Integer { .. } | Kind::Real { .. } | Kind::Duration { .. } | Kind::Text => false,
        }
    }

    /// The path, then its aliases.
    pub(crate) fn paths(&self) -> impl Iterator<Item = &'static str> {
        std::iter::once(&self.path).chain(self.aliases).copied()
    }

    /// The last part of the path: `order`.
    pub(crate) fn short(&self) -> &'static str {
        self.path.rsplit('.').next().unwrap_or(self.path)
    }

    /// The default at these indices, as a list would write it; none: the parameter has no default.
    pub(crate) fn default_at(&self, index: [u32; 2]) -> Option<&'static str> {
        let last = index[self.indices.len().saturating_sub(1)] as usize;
        self.default.get(last).or(self.default.last()).copied()
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
