//! The example repository of docs/pipelines.md, from an empty folder on: everything in it that a pipeline, a build or a person runs.

use crate::EXAMPLES;
use std::{fs, io::Write, path::Path, process::Command};

/// A machine's repository as somebody begins it.
struct Repository(tempfile::TempDir);

impl Repository {
    fn new() -> Self {
        Self::from("pipeline")
    }

    fn from(example: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        copy(&Path::new(EXAMPLES).join(example), folder.path());
        Self(folder)
    }

    /// Runs a line of a shell in it, with `axgen` on the path; gives its exit code, and what it said.
    fn shell(&self, line: &str) -> (i32, String) {
        let own = Path::new(crate::AXGEN).parent().unwrap().to_owned();
        let path = std::env::var_os("PATH").unwrap_or_default();
        let path = std::env::join_paths(std::iter::once(own).chain(std::env::split_paths(&path))).unwrap();
        let output = Command::new("sh")
            .args(["-c", line])
            .current_dir(self.0.path())
            .env("PATH", path)
            .env("CARGO_TARGET_DIR", "target")
            .output()
            .unwrap();
        let said = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap()).concat();
        (output.status.code().unwrap(), said)
    }

    fn succeeds(&self, line: &str) -> String {
        let (code, said) = self.shell(line);
        assert_eq!(code, 0, "{line}\n{said}");
        said
    }

    fn text(&self, file: &str) -> String {
        fs::read_to_string(self.0.path().join(file)).unwrap()
    }

    /// Another centre frequency in the list of the machine.
    fn change_the_list(&self) {
        let list = self.text("lists/x.lis");
        let f0 = list.lines().find(|line| line.contains("stage[0]") && line.contains("fg_f0")).unwrap();
        fs::write(self.0.path().join("lists/x.lis"), list.replace(f0, &f0.replace("53", "54"))).unwrap();
    }

    /// What a new repository runs once: its files and its vectors.
    fn begin(&self) {
        self.succeeds("axgen generate axes.toml --out generated");
        self.succeeds("axgen golden record golden/x");
    }
}

pub fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap().map(Result::unwrap) {
        let target = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), target).unwrap();
        }
    }
}

/// What stands after a key of YAML, in all its lines.
fn after<'t>(text: &'t str, key: &str) -> Vec<&'t str> {
    text.lines().filter_map(|line| line.trim().strip_prefix(key)).map(str::trim).collect()
}

/// What the pipelines and the hook run is run here too: all but the line that builds axgen.
#[test]
fn a_changed_list_fails_until_its_files_are_written_again() {
    let repository = Repository::new();
    repository.begin();
    let build = "cargo install --locked --path axgen/generator/cli";
    assert_eq!(after(&repository.text(".github/workflows/axgen.yml"), "- run:"), [build, "./check.sh"]);
    let gitlab = repository.text(".gitlab-ci.yml");
    assert!(gitlab.contains(&format!("- {build}\n  script:\n    - ./check.sh\n")), "{gitlab}");
    let hook = repository.text(".pre-commit-config.yaml");
    let [hook] = after(&hook, "entry:")[..] else { panic!("{hook}") };
    repository.succeeds("./check.sh");
    repository.succeeds(hook);
    for results in ["verify.xml", "golden.xml"] {
        let text = repository.text(results);
        assert!(text.contains("failures=\"0\""), "{text}");
        assert!(roxmltree::Document::parse(&text).is_ok());
        assert!(gitlab.contains(&format!("- {results}\n")), "{gitlab}");
    }

    repository.change_the_list();
    let (code, said) = repository.shell("./check.sh");
    assert_eq!(code, 1, "{said}");
    for line in [
        "-     * BANDPASS CRIT_DAMPING order 1 (P-AXIS-00849, 00848, 00750): centre frequency 53 Hz",
        "+     * BANDPASS CRIT_DAMPING order 1 (P-AXIS-00849, 00848, 00750): centre frequency 54 Hz",
    ] {
        assert!(said.lines().any(|said| said.starts_with(line)), "{said}");
    }
    let (code, said) = repository.shell(hook);
    assert_eq!(code, 1, "{said}");
    assert!(said.contains("generated/axis_x_ipc.c"), "{said}");

    repository.succeeds("axgen generate axes.toml --out generated");
    let (code, said) = repository.shell("./check.sh");
    assert_eq!(code, 1, "the vectors were approved for 53 Hz: {said}");
    assert!(said.contains("golden/x"), "{said}");
    repository.succeeds("axgen golden record golden/x");
    repository.succeeds("./check.sh");
}

/// What the machine's scope recorded, against the parameters of the repository.
#[test]
fn the_recording_agrees() {
    let repository = Repository::new();
    let said = repository.succeeds("axgen run axes.toml --axis X --compare recordings/x.csv");
    assert!(said.contains("agrees within the "), "{said}");
}

/// Firmware in Rust: its build script compiles the emitted C, and refuses files that are not those of the parameters.
#[test]
fn a_build_script_compiles_the_emitted_c() {
    let repository = Repository::new();
    repository.begin();
    repository.succeeds("cargo run --offline");
    repository.change_the_list();
    let (code, said) = repository.shell("cargo run --offline");
    assert!(code != 0 && said.contains("generated/axis_x_ipc.c"), "{said}");
}

/// Firmware in Rust with the crate of the emitted blocks: the tests find another block, and vectors of another.
#[test]
fn a_crate_with_the_emitted_module_tests_itself() {
    let repository = Repository::from("rust");
    repository.begin();
    let said = repository.succeeds("cargo test --offline --workspace");
    for test in [
        "axis_x_ipc::tests::this_build_has_the_bits_of_the_reference",
        "the_vectors_are_as_approved",
        "numbers_have_names",
    ] {
        assert!(said.contains(&format!("test {test} ... ok")), "{said}");
    }
    let module = repository.text("generated/axis_x_ipc.rs");
    let (start, gain) = ("STAGE0_GAIN: f64 = ", "STAGE0_GAIN: f64 = -3.0;");
    assert!(module.contains(gain));
    fs::write(repository.0.path().join("generated/axis_x_ipc.rs"), module.replace(gain, &format!("{start}-2.0;")))
        .unwrap();
    let (code, said) = repository.shell("cargo test --offline --workspace --no-fail-fast");
    assert!(code != 0 && said.matches("... FAILED").count() == 3, "{said}");
    repository.change_the_list();
    repository.succeeds("axgen generate axes.toml --out generated --force");
    let (code, said) = repository.shell("cargo test --offline --workspace --no-fail-fast");
    assert!(code != 0 && said.matches("... FAILED").count() == 1, "the vectors were approved for 53 Hz: {said}");
}

/// Firmware in C. Without CMake a plain `cargo test` says that it was left out; in CI and in an exhaustive run that is an error.
#[test]
fn cmake_builds_and_tests_the_emitted_c() {
    let repository = Repository::new();
    repository.begin();
    if repository.shell("cmake --version").0 != 0 {
        let must = crate::is_exhaustive() || std::env::var_os("CI").is_some();
        assert!(!must, "cmake is not installed: apt-get install cmake");
        // Not `eprintln`, which a test that passes keeps to itself.
        let _ = writeln!(std::io::stderr(), "NOT TESTED: cmake is not installed: apt-get install cmake");
        return;
    }
    repository.succeeds("cmake -S . -B build && cmake --build build");
    let said = repository.succeeds("cd build && ctest --output-on-failure");
    assert!(said.contains("100% tests passed, 0 tests failed out of 2"), "{said}");
}
