//! What the generator reads, checks, says and writes. All tests are one program, which is linked once, but for the one that
//! measures its own memory.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod config;
mod excitation;
mod file_forms;
mod generated;
mod inside;
mod real_files;
mod response_file;
mod structured_text;
mod write;

use generator::config::{ListOptions, Unreadable};
use generator::pipeline::{Set, read, read_with};
use generator::target::{File, TARGETS};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// A set `set.toml` next to a list of the examples, in which nothing is wrong.
fn set_of(text: &str) -> Set {
    let load = |path: &Path| match path.to_str() {
        Some("set.toml") => Ok(text.as_bytes().to_vec()),
        Some("rack-and-pinion.lis") => Ok(include_bytes!("../../examples/rack-and-pinion.lis").to_vec()),
        _ => Err(Unreadable::System("there is no such file".to_owned())),
    };
    let (set, report) = read_with(Path::new("set.toml"), &ListOptions::default(), &load);
    set.unwrap_or_else(|| panic!("{text}\n{report}"))
}

/// A set of a file, or a list at a cycle time of 1 ms.
fn from_disk(path: &Path) -> Set {
    let (set, report) = read(path, &options_of(path));
    set.unwrap_or_else(|| panic!("{}: {report}", path.display()))
}

/// A cycle time of 1 ms for a list.
fn options_of(path: &Path) -> ListOptions {
    let is_list = path.extension().is_some_and(|extension| extension == "lis");
    ListOptions { cycle_time: is_list.then(|| "1ms".to_owned()), ..ListOptions::default() }
}

/// The sets and lists that the repository ships, in order.
fn shipped(root: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    ["examples", "golden/cases"].iter().for_each(|folder| shipped_in(&root.join(folder), &mut files));
    files.sort();
    files
}

/// Sets and lists below a folder, but for what is not an input of `generate`.
fn shipped_in(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())).flatten() {
        let path = entry.path();
        let name = entry.file_name().to_string_lossy().into_owned();
        if path.is_dir() {
            shipped_in(&path, found);
        } else if name.ends_with(".lis")
            || name.ends_with(".toml") && !matches!(name.as_str(), "case.toml" | "Cargo.toml")
        {
            found.push(path);
        }
    }
}

/// The files of a set in all targets, by name.
fn files(set: &Set) -> BTreeMap<String, String> {
    let files = generator::generate::files(set, &[], &TARGETS, |made| made.file).unwrap();
    let units = generator::generate::units(set);
    let files = files.into_iter().chain(TARGETS.iter().flat_map(|target| (target.shared)(&units)));
    let files: Vec<_> = files.map(|File { name, text }| (name, text)).collect();
    let count = files.len();
    let files: BTreeMap<String, String> = files.into_iter().collect();
    assert_eq!(files.len(), count, "no two files have one name");
    files
}

/// Structured Text without its comments.
fn without_comments(text: &str) -> String {
    let (mut code, mut rest) = (String::new(), text);
    while let Some((before, comment)) = rest.split_once("(*") {
        code.push_str(before);
        rest = comment.split_once("*)").unwrap().1;
    }
    code + rest
}
