//! A structure: plain data. Reading it is elsewhere.

use super::kind::{Kind, Value};

/// A structure: its parts, including those of nested structures.
#[derive(Clone, Debug)]
pub(crate) struct Structure {
    pub(crate) name: String,
    pub(crate) parts: Vec<Part>,
}

#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) path: String,
    /// its type
    pub(crate) kind: Kind,
    /// its start value, if the text states one
    pub(crate) start: Option<Value>,
}
