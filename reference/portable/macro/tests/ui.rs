//! Each construct outside the subset has a file in `ui`, a file with its message, and a row in the guide.
//!
//! `TRYBUILD=overwrite cargo test -p axgen-portable-macro --test ui` writes the messages anew.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

#[test]
fn every_rejection_says_what_to_write() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}

#[test]
fn the_guide_has_a_row_for_every_rejection() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files: BTreeSet<_> = fs::read_dir(package.join("tests/ui"))
        .expect("the folder of the rejections")
        .map(|entry| entry.expect("a file").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned())
        .collect();
    let guide = fs::read_to_string(package.join("../../../docs/portable-rust.md")).expect("the guide");
    let (_, table) = guide.split_once("## What is rejected").expect("the chapter");
    let (table, _) = table.split_once("\n## ").expect("the next chapter");
    let rows: BTreeSet<_> = table
        .lines()
        .filter(|line| line.starts_with("| ") && line.ends_with("` |"))
        .filter_map(|line| line.rsplit('`').nth(1).map(str::to_owned))
        .collect();
    assert_eq!(files, rows, "a row of the guide ends with the name of its file");
}
