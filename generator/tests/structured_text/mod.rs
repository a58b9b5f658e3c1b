//! Structured Text: constants, what a dialect changes in a program, and which lines of a file change with what. What the
//! text computes is compared by the engines; what the file forms demand, in `file_forms`.

mod changes;
mod programs;
mod targets;

use crate::set_of;
use std::collections::BTreeMap;

/// Three axes, one of them in single precision.
const MACHINE: &str = include_str!("../../../examples/machine.toml");

/// The files of a set in all targets, by name.
fn files(text: &str) -> BTreeMap<String, String> {
    crate::files(&set_of(text))
}
