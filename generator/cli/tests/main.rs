//! The command as a user and a script see it. All tests are one program, which is linked once.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod command;
mod cortex_m4;
mod documents;
mod front_door;
#[cfg(unix)]
mod hostile;
#[cfg(unix)]
mod limited;
mod manifest;
mod measured;
mod misuse;
mod params_of;
mod pipeline;
mod recordings;
mod report;
#[cfg(unix)]
mod safety;
mod scenario;
mod set_design;
mod simulate;

use std::{path::Path, process::Command};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

const EXAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");

const AXGEN: &str = env!("CARGO_BIN_EXE_axgen");

/// Whether everything is to be run (`AXGEN_EXHAUSTIVE`), as `tests/run` does.
fn is_exhaustive() -> bool {
    std::env::var_os("AXGEN_EXHAUSTIVE").is_some_and(|value| !value.is_empty() && value != "0" && value != "false")
}

struct Run {
    code: i32,
    out: String,
    err: String,
}

impl Run {
    fn json(&self) -> serde_json::Value {
        serde_json::from_str(&self.out).unwrap_or_else(|_| panic!("{}{}", self.out, self.err))
    }
}

fn axgen(folder: impl AsRef<Path>, arguments: &[&str]) -> Run {
    let output = Command::new(AXGEN).current_dir(folder).args(arguments).output().unwrap();
    let [out, err] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    Run { code: output.status.code().unwrap(), out, err }
}

/// The same of words between blanks: its exit code, its output and its messages.
fn words(folder: impl AsRef<Path>, command: &str) -> (i32, String, String) {
    let Run { code, out, err } = axgen(folder, &command.split_whitespace().collect::<Vec<_>>());
    (code, out, err)
}
