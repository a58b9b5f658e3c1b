//! What the names of a block in C begin with.

use crate::target::{Header, block_name};

/// What the names of a block's types, functions and files begin with. The longest name that linkers see is `.._inputs_init`: with a short
/// name of the block, and the longest one that an axis may have then, it has 31 characters.
pub(crate) fn prefix(axis: &Header, block: &str) -> String {
    match axis.short_name {
        Some(short) => format!("ax_{}_{short}", axis.name.to_ascii_lowercase()),
        None => block_name(&axis.name, block),
    }
}
