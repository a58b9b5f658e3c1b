//! The beginning of a block's names in C.

use crate::blocks::{self, BlockKind};
use crate::target::{BlockIdentity, block_name, with_self_test};

/// What the names of a block's types, functions and files begin with. The longest name that linkers see is
/// `.._inputs_init`: with a short name of the block, and the longest one that an axis may have then, it has 31
/// characters.
pub(crate) fn prefix(axis: &BlockIdentity, block: &str) -> String {
    called(&axis.name, block, axis.short_names)
}

/// The struct of the parameter sets of an axis.
pub(crate) fn set(axis: &BlockIdentity) -> String {
    format!("{}_params", prefix(axis, blocks::IPC))
}

/// A block and its self-test.
pub(crate) fn block_and_test(axis: &str, block: &str, is_short: bool) -> [String; 2] {
    with_self_test(called(axis, block, is_short))
}

fn called(axis: &str, block: &str, is_short: bool) -> String {
    match blocks::named(block).filter(|_| is_short).map(BlockKind::short_name) {
        Some(short) => format!("ax_{}_{short}", axis.to_ascii_lowercase()),
        None => block_name(axis, block),
    }
}
