//! A standard output that takes no more: the environment, with a message, whatever the command is.

#![cfg(target_os = "linux")]

use super::{started, write_case};
use std::process::{Command, Output};
use std::{fs::File, path::Path};

/// Every command that prints, one a line.
const PRINT: &str = include_str!("printing.txt");

fn into_full(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(crate::AXGEN);
    command.current_dir(folder).args(arguments.split(' '));
    command.stdout(File::options().write(true).open("/dev/full").unwrap());
    command
}

#[test]
fn a_standard_output_that_is_full_is_the_environment() {
    let folder = started();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("in.csv", "v_motor\n1.0\n");
    write("recorded.csv", "v_motor,v_add\n1.0,0.0\n");
    write("x.lis", "kopf.achs_nr 1\n");
    write_case(folder.path());
    for arguments in PRINT.lines() {
        let Output { status, stderr, .. } = into_full(folder.path(), arguments).output().unwrap();
        let err = String::from_utf8(stderr).unwrap();
        assert_eq!(status.code(), Some(3), "{arguments}: {err}");
        let last = err.lines().last().unwrap_or_default();
        assert_eq!(last, "standard output: error[AX017]: No space left on device (os error 28)", "{arguments}");
    }
}

/// Nobody can be told; the exit code says it.
#[test]
fn a_standard_error_that_is_full_too_changes_nothing() {
    let folder = started();
    for (arguments, code) in [("params", 3), ("params bandwidth", 2), ("check not-there.toml", 2), ("--speed", 2)] {
        let mut command = into_full(folder.path(), arguments);
        command.stderr(File::options().write(true).open("/dev/full").unwrap());
        assert_eq!(command.status().unwrap().code(), Some(code), "{arguments}");
    }
}
