//! A structure: plain data. What reads it is elsewhere.

use super::kind::{Kind, Value};

/// A structure: its parts, those of structures inside it too.
#[derive(Clone, Debug)]
pub(crate) struct Structure {
    /// its name
    pub(crate) name: String,
    /// its parts
    pub(crate) parts: Vec<Part>,
}

/// A part of a structure.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    /// its path
    pub(crate) path: String,
    /// its type
    pub(crate) kind: Kind,
    /// what it is at the start, if the text says it
    pub(crate) start: Option<Value>,
}
