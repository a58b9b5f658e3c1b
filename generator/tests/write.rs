//! Files go into a folder all together or not at all, and nothing else is left there.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use generator::digest::{UNSEALED, seal};
use generator::target::File;
use generator::write::{Refusal, Written, commit, edited_by_hand, stage};
use std::fs;
use std::path::Path;

fn file(name: &str, text: &str) -> File {
    File { name: name.to_owned(), text: text.to_owned() }
}

fn write(folder: &Path, files: &[File], force: bool) -> Result<Written, Refusal> {
    commit(files.iter().map(|file| stage(folder, file)).collect(), force)
}

/// The names and texts of all files of a folder.
fn content(folder: &Path) -> Vec<(String, String)> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut content: Vec<_> = entries
        .filter(|path| path.is_file())
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), fs::read_to_string(&path).unwrap()))
        .collect();
    content.sort();
    content
}

fn pair(name: &str, text: &str) -> (String, String) {
    (name.to_owned(), text.to_owned())
}

#[test]
fn new_changed_and_unchanged_files() {
    let folder = tempfile::tempdir().unwrap();
    let first = write(folder.path(), &[file("a", "1"), file("b", "1")], false).unwrap();
    assert_eq!(first, Written { changed: 2, unchanged: 0 });
    let second = write(folder.path(), &[file("a", "1"), file("b", "2"), file("c", "3")], false).unwrap();
    assert_eq!(second, Written { changed: 2, unchanged: 1 });
    assert_eq!(content(folder.path()), [pair("a", "1"), pair("b", "2"), pair("c", "3")]);
}

#[test]
fn one_that_cannot_be_written_keeps_all_from_being_written() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a"), "old").unwrap();
    fs::create_dir(folder.path().join("b")).unwrap();
    let result = write(folder.path(), &[file("a", "new"), file("b", "1"), file("c", "1")], false);
    assert!(matches!(result, Err(Refusal::Failed(path, _)) if path == folder.path().join("b")));
    assert_eq!(content(folder.path()), [pair("a", "old")]);
}

#[test]
fn a_failing_rename_puts_everything_back() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a"), "old").unwrap();
    let staged = [file("a", "new"), file("b", "1"), file("c", "1")].map(|file| stage(folder.path(), &file));
    // Somebody makes a folder where the last file goes, after it was staged.
    fs::create_dir_all(folder.path().join("c/occupied")).unwrap();
    let result = commit(staged.into_iter().collect(), false);
    assert!(matches!(result, Err(Refusal::Failed(path, _)) if path == folder.path().join("c")));
    assert_eq!(content(folder.path()), [pair("a", "old")]);
    assert!(folder.path().join("c/occupied").is_dir());
}

#[test]
fn what_was_edited_by_hand_needs_force() {
    let folder = tempfile::tempdir().unwrap();
    let generated = |body: &str| seal(format!("/* x.c\n *\n * body        {UNSEALED}\n */\n{body}\n"));
    assert!(!edited_by_hand(generated("int a;").as_bytes()));
    assert!(edited_by_hand(generated("int a;").replace("int", "long").as_bytes()));
    assert!(!edited_by_hand(generated("int a;").replace('\n', "\r\n").as_bytes()), "other line ends are no edit");
    assert!(!edited_by_hand(b"a file of another tool"));

    fs::write(folder.path().join("x.c"), generated("int a;").replace("int", "long")).unwrap();
    let files = [file("x.c", &generated("int b;")), file("y.c", "1")];
    let refused = write(folder.path(), &files, false);
    assert!(matches!(refused, Err(Refusal::Edited(paths)) if paths == [folder.path().join("x.c")]));
    assert_eq!(content(folder.path()).len(), 1);
    write(folder.path(), &files, true).unwrap();
    assert_eq!(content(folder.path()), [pair("x.c", &generated("int b;")), pair("y.c", "1")]);
}
