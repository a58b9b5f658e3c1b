//! A single file that a command was asked for: what a killed run left next to it is cleared, what a running one has there is not.

use super::{content, pair};
use generator::write::{Replace, stage_one};
use std::fs::{self, File};

#[test]
fn a_killed_run_blocks_no_other() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.toml");
    // In a container the next run mostly has the number of the killed one.
    let number = std::process::id();
    for name in [format!("x.toml.axgen-staged-{number}"), "x.toml.axgen-staged-1".to_owned()] {
        fs::write(folder.path().join(name), "half").unwrap();
    }
    fs::write(folder.path().join("y.toml.axgen-staged-1"), "of another file").unwrap();
    stage_one(&path, b"whole", Replace::None).unwrap().commit().unwrap();
    assert_eq!(content(folder.path()), [pair("x.toml", "whole"), pair("y.toml.axgen-staged-1", "of another file")]);
}

#[test]
fn a_running_one_keeps_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.toml");
    let others = folder.path().join("x.toml.axgen-staged-1");
    fs::write(&others, "half").unwrap();
    let held = File::open(&others).unwrap();
    held.lock().unwrap();
    let first = stage_one(&path, b"first", Replace::None).unwrap();
    let refused = stage_one(&path, b"second", Replace::None).unwrap_err().to_string();
    assert!(refused.ends_with("is in the way"), "{refused}");
    first.commit().unwrap();
    assert_eq!(content(folder.path()), [pair("x.toml", "first"), pair("x.toml.axgen-staged-1", "half")]);
}
