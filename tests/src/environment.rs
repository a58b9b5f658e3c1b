//! What the host offers, and how much a test run is to do.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, OnceLock};

/// Whether everything is to be run (`AXGEN_EXHAUSTIVE`): all samples, all levels.
#[must_use]
pub fn is_exhaustive() -> bool {
    is_set("AXGEN_EXHAUSTIVE")
}

/// Whether even what an exhaustive run does in turn is to be run (`AXGEN_EVERY_LEVEL`): every case with every level, option and engine.
#[must_use]
pub fn is_every_level() -> bool {
    is_set("AXGEN_EVERY_LEVEL")
}

/// What there is of something: in a plain run, in an exhaustive one, and where even what that does in turn is to be run.
#[must_use]
pub fn by_depth<T>(plain: T, exhaustive: T, every: T) -> T {
    match (is_every_level(), is_exhaustive()) {
        (true, _) => every,
        (_, true) => exhaustive,
        _ => plain,
    }
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

/// The program axgen, built as the tests are: the one that `AXGEN` names, as `tests/run` does, else built here. Cargo builds it otherwise for
/// itself than next to all tests, whose packages ask for more features of the same libraries, and takes a minute or two for it.
///
/// # Panics
/// If it does not build.
#[must_use]
pub fn axgen() -> PathBuf {
    static BUILT: OnceLock<PathBuf> = OnceLock::new();
    let built = BUILT.get_or_init(|| {
        if let Some(built) = std::env::var_os("AXGEN") {
            return built.into();
        }
        // TARGET/PROFILE/deps/this-test
        let test = std::env::current_exe().unwrap_or_else(|error| panic!("axgen: {error}"));
        let folder = test.parent().and_then(Path::parent).unwrap_or_else(|| panic!("axgen: {}", test.display()));
        let mut build = Command::new(std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()));
        build.args(["build", "--quiet", "--locked", "--package", "axgen", "--target-dir"]);
        build.arg(folder.parent().unwrap_or(folder)).current_dir(env!("CARGO_MANIFEST_DIR"));
        if folder.file_name().is_some_and(|profile| profile == "release") {
            build.arg("--release");
        }
        assert!(build.status().is_ok_and(|status| status.success()), "axgen does not build");
        folder.join("axgen")
    });
    built.clone()
}

fn is_set(variable: &str) -> bool {
    std::env::var_os(variable).is_some_and(|value| !value.is_empty() && value != "0" && value != "false")
}
