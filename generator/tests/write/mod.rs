//! Files go into a folder all together or not at all, and nothing else is left there.

mod failures;
mod folders;
mod left_overs;
mod links;
mod owners;
mod single;

use generator::target::File;
use generator::write::{Refusal, Written, commit, open, stage};
use std::fs;
use std::path::Path;

fn file(name: &str, text: &str) -> File {
    File { name: name.to_owned(), text: text.to_owned() }
}

fn write(folder: &Path, files: &[File], force: bool) -> Result<Written, Refusal> {
    let folder = open(folder)?;
    let staged = files.iter().map(|file| stage(&folder, file)).collect();
    commit(folder, staged, force)
}

/// The names and texts of all files of a folder, links and folders with what they are.
fn content(folder: &Path) -> Vec<(String, String)> {
    let mut content: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| {
            let path = entry.unwrap().path();
            let kind = fs::symlink_metadata(&path).unwrap().file_type();
            let text = if kind.is_symlink() {
                format!("-> {}", fs::read_link(&path).unwrap().display())
            } else if kind.is_dir() {
                "a folder".to_owned()
            } else {
                fs::read_to_string(&path).unwrap()
            };
            (path.file_name().unwrap().to_string_lossy().into_owned(), text)
        })
        .collect();
    content.sort();
    content
}

fn pair(name: &str, text: &str) -> (String, String) {
    (name.to_owned(), text.to_owned())
}

/// A file as a generator would make it.
fn generated(name: &str, body: &str) -> File {
    let line = generator::digest::NO_CHECKSUM;
    file(name, &generator::digest::with_checksum(format!("/* {name}\n *\n * checksum    {line}\n */\n{body}\n")))
}

#[test]
fn new_changed_and_unchanged_files() {
    let folder = tempfile::tempdir().unwrap();
    let [a, b, b2, c] = [("a", "1"), ("b", "1"), ("b", "2"), ("c", "3")].map(|(name, body)| generated(name, body));
    let first = write(folder.path(), &[a.clone(), b], false).unwrap();
    assert_eq!(first, Written { changed: 2, unchanged: 0 });
    let second = write(folder.path(), &[a.clone(), b2.clone(), c.clone()], false).unwrap();
    assert_eq!(second, Written { changed: 2, unchanged: 1 });
    assert_eq!(content(folder.path()), [a, b2, c].map(|file| (file.name, file.text)));
}
