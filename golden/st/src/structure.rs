//! A structure: plain data. Reading it is elsewhere.

use super::kind::{Kind, Value};

/// A structure: its parts, including those of nested structures.
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
    /// its start value, if the text states one
    pub(crate) start: Option<Value>,
}
