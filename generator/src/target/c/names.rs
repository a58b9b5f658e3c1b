//! What the names of a block in C begin with.

use crate::target::{Header, block_name};

/// What the names of a block's types, functions and files begin with.
pub(super) fn prefix(axis: &Header, block: &str) -> String {
    block_name(&axis.name, block)
}
