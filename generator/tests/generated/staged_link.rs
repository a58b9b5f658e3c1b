//! A staged file is made new: whatever somebody puts in its place after the folder was opened is neither followed nor
//! overwritten.

#![cfg(unix)]

use generator::target::File;
use generator::write::{Refusal, commit, open, stage};
use std::fs;
use std::os::unix::fs::symlink;

/// The name of a staged file holds the process's number: it can be guessed.
fn staged() -> String {
    format!("a.axgen-staged-{}", std::process::id())
}

fn file() -> File {
    File { name: "a".to_owned(), text: "new".to_owned() }
}

#[test]
fn a_link_that_appears_after_the_folder_was_opened_is_not_followed() {
    for target in ["precious", "nothing"] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("precious"), "mine").unwrap();
        let held = open(folder.path()).unwrap();
        symlink(target, folder.path().join(staged())).unwrap();
        let result = stage(&held, &file());
        let is_refused = matches!(&result, Err(Refusal::Failed(path, error))
            if *path == folder.path().join("a") && error.kind() == std::io::ErrorKind::AlreadyExists);
        assert!(is_refused, "{target}: {result:?}");
        commit(held, vec![result], true).unwrap_err();
        assert_eq!(
            fs::read_to_string(folder.path().join("precious")).unwrap(),
            "mine",
            "nothing went through the link"
        );
        assert!(!folder.path().join("nothing").exists(), "nothing was made through the link");
        assert!(!folder.path().join("a").exists());
    }
}

#[test]
fn a_file_that_appears_after_the_folder_was_opened_is_not_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let held = open(folder.path()).unwrap();
    fs::write(folder.path().join(staged()), "another's").unwrap();
    let result = stage(&held, &file());
    assert!(matches!(result, Err(Refusal::Failed(..))), "{result:?}");
    assert_eq!(fs::read_to_string(folder.path().join(staged())).unwrap(), "another's");
}
