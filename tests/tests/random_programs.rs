//! Random programs of the portable subset, run by every engine.
//!
//! `AXGEN_RANDOM_SEED` makes other programs, `AXGEN_RANDOM_PROGRAMS` more or fewer: 100,000 take about an hour.

#![expect(clippy::print_stdout, reason = "what the run has covered")]

use axgen_tests::environment::by_depth;
use axgen_tests::random::campaign::{self, Settings};
use axgen_tests::random::print;
use inside::defect::DEFECTS;
use std::path::PathBuf;

/// Where crates and C are built.
fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("random")
}

#[test]
fn random_programs_agree_in_every_engine() {
    let folder = folder();
    let report = campaign::run(&Settings::from_environment(&folder, "random-programs")).unwrap();
    for (construct, count) in &report.shares {
        println!("{:5.1} % {construct}", 100.0 * *count as f64 / report.programs as f64);
    }
    assert!(report.shrunk.is_none(), "{:?} differ; the smallest:\n{}", report.different, report.shrunk.unwrap().text);
}

#[test]
fn a_planted_defect_is_found_and_made_small() {
    let folder = folder();
    // One that the interpreter has; what a printer has is compiled in every round of the shrinking.
    for (name, defect) in DEFECTS.into_iter().take(by_depth(1, 1, 2)) {
        let settings = Settings { folder: &folder, name, seed: 1, programs: 20, defect: Some(defect) };
        let report = campaign::run(&settings).unwrap();
        let shrunk = report.shrunk.unwrap_or_else(|| panic!("{name} is not found"));
        println!("{name}\n{}", shrunk.text);
        assert!(print::lines(&shrunk.program) <= 30, "{name}: {}", shrunk.text);
    }
}
