//! Links: a folder may be one, a file may not, for what lies after it belongs to somebody else.

#![cfg(unix)]

use super::{content, generated, pair, write};
use generator::write::Refusal;
use std::fs;
use std::os::unix::fs::symlink;

#[test]
fn nothing_is_written_through_a_link_nor_in_its_place() {
    for target in ["elsewhere", "nothing", "a"] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("elsewhere"), generated("a", "old").text).unwrap();
        symlink(target, folder.path().join("a")).unwrap();
        let before = content(folder.path());
        for force in [false, true] {
            let refusal = write(folder.path(), &[generated("a", "new"), generated("b", "new")], force).unwrap_err();
            assert!(matches!(&refusal, Refusal::Failed(path, _) if *path == folder.path().join("a")));
            let said = "is a symbolic link, through which nothing is written; nothing was written";
            assert!(refusal.report().to_string().trim_end().ends_with(said), "{refusal:?}");
        }
        assert_eq!(content(folder.path()), before);
    }
}

#[test]
fn a_link_to_what_would_be_written_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    let a = generated("a", "1");
    fs::write(folder.path().join("elsewhere"), &a.text).unwrap();
    symlink("elsewhere", folder.path().join("a")).unwrap();
    assert_eq!(write(folder.path(), std::slice::from_ref(&a), false).unwrap().unchanged, 1);
    assert_eq!(content(folder.path()), [pair("a", "-> elsewhere"), pair("elsewhere", &a.text)]);
}

/// Other names of the same file keep its old content.
#[test]
fn another_name_of_a_file_keeps_the_old_content() {
    let folder = tempfile::tempdir().unwrap();
    let (old, new) = (generated("a", "old"), generated("a", "new"));
    fs::write(folder.path().join("a"), &old.text).unwrap();
    fs::hard_link(folder.path().join("a"), folder.path().join("other")).unwrap();
    write(folder.path(), std::slice::from_ref(&new), false).unwrap();
    assert_eq!(content(folder.path()), [pair("a", &new.text), pair("other", &old.text)]);
}

#[test]
fn a_folder_that_is_a_link_is_followed() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("real")).unwrap();
    symlink("real", folder.path().join("out")).unwrap();
    write(&folder.path().join("out"), &[generated("a", "1")], false).unwrap();
    assert_eq!(content(folder.path()), [pair("out", "-> real"), pair("real", "a folder")]);
    assert!(folder.path().join("real/a").is_file());
    symlink("nothing", folder.path().join("dangling")).unwrap();
    assert!(matches!(write(&folder.path().join("dangling"), &[generated("a", "1")], false), Err(Refusal::Failed(..))));
    assert!(!folder.path().join("nothing").exists());
}
