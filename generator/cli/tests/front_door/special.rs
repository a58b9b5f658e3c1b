//! Files that are no files: pipes that nobody writes into, devices without an end. No command waits for one, or fills the memory.

#![cfg(unix)]

use super::{axgen, started};
use crate::limited::{self, Limits};
use std::fs::{self, File};
use std::process::{Command, Stdio};
use std::time::Duration;
use std::{os::unix::fs::symlink, path::Path};

/// No such file may keep a command busy for longer; the tests run side by side.
const LIMITS: Limits = Limits { time: Duration::from_secs(60), memory: 2_097_152 };

const NO_FILE: &str = "error[AX001]: cannot be read: it is not a regular file, but a device, a pipe or a socket\n";

/// Runs the command with little memory, and ends it when its time is over.
fn bounded(folder: &Path, arguments: &str, input: Stdio) -> (i32, String) {
    let output = limited::run(folder, arguments.split(' '), input, &LIMITS);
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}

fn pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

#[test]
fn a_pipe_or_a_device_in_the_place_of_a_generated_file_is_named() {
    let folder = started();
    let target = folder.path().join("generated/axis_x_ipc.c");
    for device in [None, Some("/dev/zero")] {
        assert_eq!(axgen(folder.path(), &["generate", "axes.toml", "--force"]).0, 0);
        fs::remove_file(&target).unwrap();
        match device {
            None => pipe(&target),
            Some(device) => symlink(device, &target).unwrap(),
        }
        for option in ["--check", "--diff"] {
            let said = bounded(folder.path(), &format!("generate axes.toml {option}"), Stdio::null());
            assert_eq!(said, (3, format!("generated/axis_x_ipc.c: {NO_FILE}")), "{device:?}");
        }
        fs::remove_file(&target).unwrap();
    }
}

#[test]
fn samples_are_read_from_regular_files_and_from_standard_input() {
    let folder = started();
    let path = folder.path();
    pipe(&path.join("pipe.csv"));
    fs::write(path.join("in.csv"), "v_motor\n1.0\n").unwrap();
    File::create(path.join("large.csv")).unwrap().set_len((256 << 20) + 1).unwrap();
    let large = "error[AX002]: is too large\n    allowed: 256 MiB\n";
    for option in ["--stimulus", "--compare"] {
        for (file, said) in [("pipe.csv", NO_FILE), ("/dev/zero", NO_FILE), ("large.csv", large)] {
            let found = bounded(path, &format!("run axes.toml {option} {file}"), Stdio::null());
            assert_eq!(found, (2, format!("{file}: {said}")));
        }
        let zeros = Stdio::from(File::open("/dev/zero").unwrap());
        let found = bounded(path, &format!("run axes.toml {option} -"), zeros);
        assert_eq!(found, (2, format!("standard input: {large}")));
    }
    let input = Stdio::from(File::open(path.join("in.csv")).unwrap());
    assert_eq!(bounded(path, "run axes.toml --stimulus -", input), (0, String::new()));
}

#[test]
fn a_golden_case_is_read_from_regular_files() {
    let folder = started();
    fs::create_dir(folder.path().join("case")).unwrap();
    pipe(&folder.path().join("case/case.toml"));
    let said = bounded(folder.path(), "golden verify case", Stdio::null());
    let found = NO_FILE.trim_start_matches("error[AX001]: ");
    assert_eq!(said, (2, format!("case: error[AX016]: case/case.toml: {found}")));
}
