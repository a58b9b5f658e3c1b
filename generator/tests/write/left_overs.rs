//! What a killed run left next to its targets is cleared by the next one.

use super::{content, generated, pair, write};
use std::fs;

#[test]
fn staged_and_kept_files_of_a_killed_run_are_cleared() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("below")).unwrap();
    fs::write(folder.path().join("a"), generated("a", "old").text).unwrap();
    for name in ["a.axgen-staged-1", "a.axgen-kept-1", "below/b.axgen-staged-7"] {
        fs::write(folder.path().join(name), "left").unwrap();
    }
    // No file of this run goes next to it: its checksum says that it is ours.
    fs::write(folder.path().join("gone.axgen-staged-4294967295"), generated("gone", "1").text).unwrap();
    let [a, b] = [generated("a", "1"), generated("below/b", "1")];
    write(folder.path(), &[a.clone(), b.clone()], false).unwrap();
    assert_eq!(content(folder.path()), [(a.name, a.text), pair("below", "a folder")]);
    assert_eq!(content(&folder.path().join("below")), [pair("b", &b.text)]);
}

#[test]
fn what_only_looks_like_it_stays() {
    let folder = tempfile::tempdir().unwrap();
    let names = [
        "a.axgen-staged-x",
        "a.axgen-staged-",
        "a.axgen-staged-1a",
        "a.axgen-other-1",
        "a.staged-1",
        "axgen-kept-1",
        ".axgen-kept-1",
    ];
    for name in names {
        fs::write(folder.path().join(name), "").unwrap();
    }
    write(folder.path(), &[generated("b", "1")], false).unwrap();
    assert_eq!(content(folder.path()).len(), names.len() + 1);
}
