//! A failure at any position leaves every file as it was.

use super::{content, file, generated, pair, write};
use generator::write::{Refusal, commit, open, stage};
use std::fs;
use std::path::Path;

const NAMES: [&str; 6] = ["a", "b", "c", "d", "e", "f"];

/// Every second file is there already.
fn older(folder: &Path) -> Vec<(String, String)> {
    for name in NAMES.iter().step_by(2) {
        let older = generated(name, "old");
        fs::write(folder.join(name), older.text).unwrap();
    }
    content(folder)
}

#[test]
fn a_folder_in_the_place_of_any_file_keeps_all_from_being_staged() {
    for name in NAMES {
        let folder = tempfile::tempdir().unwrap();
        older(folder.path());
        let _ = fs::remove_file(folder.path().join(name));
        fs::create_dir(folder.path().join(name)).unwrap();
        let before = content(folder.path());
        let result = write(folder.path(), &NAMES.map(|name| generated(name, "new")), true);
        assert!(matches!(result, Err(Refusal::Failed(path, _)) if path == folder.path().join(name)));
        assert_eq!(content(folder.path()), before);
    }
}

/// Somebody makes a folder where a file goes, after it was staged: the renaming fails there, with others after it.
#[test]
fn a_failing_rename_at_any_position_puts_everything_back() {
    for (position, name) in NAMES.iter().enumerate() {
        let folder = tempfile::tempdir().unwrap();
        older(folder.path());
        let held = open(folder.path()).unwrap();
        let staged = NAMES.map(|name| stage(&held, &generated(name, "new")));
        let _ = fs::remove_file(folder.path().join(name));
        fs::create_dir_all(folder.path().join(name).join("occupied")).unwrap();
        let is_staged = |(name, _): &(String, String)| name.contains(".axgen-");
        let mut before = content(folder.path());
        before.retain(|file| !is_staged(file));
        let result = commit(held, staged.into_iter().collect(), false);
        assert!(
            matches!(&result, Err(Refusal::Failed(path, _)) if *path == folder.path().join(name)),
            "{position}: {result:?}"
        );
        assert_eq!(content(folder.path()), before, "position {position}");
        assert!(folder.path().join(name).join("occupied").is_dir());
    }
}

#[test]
fn a_staged_file_that_is_gone_puts_everything_back() {
    for name in NAMES {
        let folder = tempfile::tempdir().unwrap();
        let before = older(folder.path());
        let held = open(folder.path()).unwrap();
        let staged = NAMES.map(|name| stage(&held, &generated(name, "new")));
        fs::remove_file(folder.path().join(format!("{name}.axgen-staged-{}", std::process::id()))).unwrap();
        let result = commit(held, staged.into_iter().collect(), false);
        assert!(matches!(result, Err(Refusal::Failed(path, _)) if path == folder.path().join(name)));
        assert_eq!(content(folder.path()), before);
    }
}

#[test]
fn what_was_put_back_is_the_same_file_with_its_time() {
    let folder = tempfile::tempdir().unwrap();
    older(folder.path());
    let modified = || fs::metadata(folder.path().join("a")).unwrap().modified().unwrap();
    let before = modified();
    let held = open(folder.path()).unwrap();
    let staged = ["a", "b"].map(|name| stage(&held, &generated(name, "new")));
    fs::create_dir(folder.path().join("b")).unwrap();
    commit(held, staged.into_iter().collect(), false).unwrap_err();
    assert_eq!(modified(), before);
}

#[test]
fn a_panic_leaves_nothing_staged() {
    let folder = tempfile::tempdir().unwrap();
    let before = older(folder.path());
    let out = folder.path().to_owned();
    let panicked = std::thread::spawn(move || {
        let held = open(&out).unwrap();
        let _staged = NAMES.map(|name| stage(&held, &generated(name, "new")).unwrap());
        assert!(out.read_dir().unwrap().count() > NAMES.len(), "they are staged now");
        std::panic::resume_unwind(Box::new("a defect"));
    });
    assert!(panicked.join().is_err());
    assert_eq!(content(folder.path()), before);
    write(folder.path(), &[generated("a", "new")], false).unwrap();
}

#[test]
fn a_folder_that_was_made_goes_again() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("x/../y/z");
    fs::create_dir(folder.path().join("x")).unwrap();
    fs::write(folder.path().join("a file"), "").unwrap();
    for files in [[generated("twincat/a", "1"), generated("a/b", "1")], [generated("a", "1"), generated("b\0", "1")]] {
        let held = open(&out).unwrap();
        let mut staged: Vec<_> = files.iter().map(|file| stage(&held, file)).collect();
        staged.push(Err(Refusal::Failed(out.clone(), std::io::Error::other("no"))));
        commit(held, staged, false).unwrap_err();
        assert_eq!(content(folder.path()), [pair("a file", ""), pair("x", "a folder")]);
    }
}

#[test]
fn a_file_in_the_place_of_a_folder() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("out"), "a file").unwrap();
    for out in ["out", "out/below"] {
        assert!(matches!(write(&folder.path().join(out), &[file("a", "1")], false), Err(Refusal::Failed(..))));
    }
    assert!(matches!(write(folder.path(), &[file("b", "1"), file("out/a", "1")], false), Err(Refusal::Failed(..))));
    assert_eq!(content(folder.path()), [pair("out", "a file")]);
}
