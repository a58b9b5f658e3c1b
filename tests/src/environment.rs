//! What the host offers, and how much a test run is to do.

use std::collections::BTreeSet;
use std::io::Write;
use std::process::Command;
use std::sync::Mutex;

/// Whether everything is to be run (`AXGEN_EXHAUSTIVE`): all samples, all levels.
#[must_use]
pub fn is_exhaustive() -> bool {
    is_set("AXGEN_EXHAUSTIVE")
}

/// Whether a program is there, judged by what it says of its version.
///
/// Where it is not, a plain `cargo test` goes on without it and says so, past the capture of test output; in CI and in an
/// exhaustive run the test fails.
///
/// # Panics
/// If the program is not there in CI or in an exhaustive run.
#[must_use]
pub fn has(program: &str, version_contains: &str, package: &str) -> bool {
    if said(program, "--version").is_some_and(|version| version.contains(version_contains)) {
        return true;
    }
    let missing = format!("{program} is not installed: apt-get install {package}");
    assert!(!is_set("CI") && !is_exhaustive(), "{missing}");
    if said_once(&missing) {
        // Not `eprintln`, which a test that passes keeps to itself.
        let _ = writeln!(std::io::stderr(), "NOT TESTED: {missing}");
    }
    false
}

/// Whether it is said for the first time.
fn said_once(text: &str) -> bool {
    static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    SAID.lock().is_ok_and(|mut said| said.insert(text.to_owned()))
}

/// What a program answers to an option; `None`: it is not there.
#[must_use]
pub fn said(program: &str, option: &str) -> Option<String> {
    let output = Command::new(program).arg(option).output().ok()?;
    Some(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Whether the processor multiplies and adds in one operation.
#[must_use]
pub fn has_fma() -> bool {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    !cfg!(target_arch = "x86_64") || cpu.split_whitespace().any(|flag| flag == "fma")
}

fn is_set(variable: &str) -> bool {
    std::env::var_os(variable).is_some_and(|value| !value.is_empty() && value != "0" && value != "false")
}
