//! Structured Text: constants, what a dialect changes in a program, and which lines of a file change with what. What the
//! text computes is compared by the engines; what the file forms demand, in `file_forms`.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod changes;
mod programs;
mod targets;

use generator::config::{ListOptions, Unreadable};
use generator::pipeline::{Set, read_with};
use generator::target::{File, TARGETS};
use std::collections::BTreeMap;
use std::path::Path;

/// Three axes, one of them in single precision.
const MACHINE: &str = include_str!("../../../examples/machine.toml");
const LIST: &[u8] = include_bytes!("../../../examples/rack-and-pinion.lis");

/// A set next to `rack-and-pinion.lis`.
fn set(text: &str) -> Set {
    let load = |path: &Path| match path.to_str() {
        Some("set.toml") => Ok(text.as_bytes().to_vec()),
        Some("rack-and-pinion.lis") => Ok(LIST.to_vec()),
        _ => Err(Unreadable::System("there is no such file".to_owned())),
    };
    let (set, report) = read_with(Path::new("set.toml"), &ListOptions::default(), &load);
    set.unwrap_or_else(|| panic!("{report}"))
}

/// The files of a set in all targets, by name.
fn files(text: &str) -> BTreeMap<String, String> {
    let set = &set(text);
    let files = generator::generate::files(set, &[], &TARGETS, |made| made.file).unwrap();
    let units = generator::generate::units(set);
    let files = files.into_iter().chain(TARGETS.iter().flat_map(|target| (target.shared)(&units)));
    let files: Vec<_> = files.map(|File { name, text }| (name, text)).collect();
    let count = files.len();
    let files: BTreeMap<String, String> = files.into_iter().collect();
    assert_eq!(files.len(), count, "no two files have one name");
    files
}
