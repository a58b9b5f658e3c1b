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

/// The names of the files that hold the block `ipc` of an axis, and its self-test.
fn of_ipc(axis: &str) -> Vec<String> {
    let ends = ["c", "h", "rs", "scl", "st", "xml"].map(|end| format!("axis_{axis}_ipc.{end}"));
    let tests = ["c", "scl", "st", "xml"].map(|end| format!("axis_{axis}_ipc_self_test.{end}"));
    let objects = ["POUs/FB_axis_NAME_ipc", "Tests/FB_axis_NAME_ipc_Test", "Tests/FB_axis_NAME_ipc_self_test"];
    let objects = objects.map(|object| format!("twincat/{}.TcPOU", object.replace("NAME", axis)));
    [ends.as_slice(), &tests, &objects].concat()
}
