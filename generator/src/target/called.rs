//! The names in a target of a block, its self-test and its outputs, for texts for the user.

use super::{TARGETS, Target};
use compiler::legalise::{NOTICE, RENAMED};

/// The pass after which a block has the signals of PLCopen.
const ENABLED: &str = "enabled";

impl Target {
    /// Whether its blocks have the signals of PLCopen.
    pub(crate) fn has_enable(&self) -> bool {
        self.passes.iter().any(|(name, _)| *name == ENABLED)
    }

    /// The name of a block of an axis, and that of the block's self-test; `is_short`: whether the axis uses short names in C.
    pub(crate) fn called(&self, axis: &str, block: &str, is_short: bool) -> [String; 2] {
        (self.called)(axis, block, is_short)
    }

    /// The name of an output of a block.
    pub(crate) fn output<'n>(&self, name: &'n str) -> &'n str {
        let renamed = RENAMED.into_iter().find(|(own, _)| *own == name && self.has_enable());
        renamed.map_or(name, |(_, other)| other)
    }

    /// The name of the output with the id of a notice.
    pub(crate) fn notice(&self) -> &'static str {
        if self.has_enable() { NOTICE } else { "error_id" }
    }

    /// Whether a self-test in this target is a function, not a function block.
    pub(crate) fn tests_by_function(&self) -> bool {
        ["c", "rust"].contains(&self.name)
    }
}

/// The targets of these names, in the order of the registry.
pub fn of_names(is_named: impl Fn(&str) -> bool) -> Vec<Target> {
    TARGETS.into_iter().filter(|target| is_named(target.name)).collect()
}
