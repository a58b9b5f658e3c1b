//! The emitted C under real compilers: the same bits at every level, no warning, no undefined symbol, and what becomes of
//! options that change bits. With `AXGEN_EXHAUSTIVE=1` all of it, else a part.
//!
//! A compiler that is not there is said, past the capture of test output; in CI and in an exhaustive run it is a failure.
#![forbid(unsafe_code)]

mod bare;
mod boards;
mod clang;
mod files;
mod flags;
mod matrix;
mod random_axes;
mod random_modules;
mod runners;
mod unity;

use axgen_tests::cases::{in_both_real_types, title};
use axgen_tests::environment;
use golden::case::{self, Case};
use golden::engine::{self, Engine};
use golden::samples::Samples;

/// The cases of a plain run: one with everything, one in single precision, a small one, and one whose output is always 0.
const QUICK_CASES: [&str; 4] =
    ["three-full-stages, f64", "single-precision, f32", "rack-and-pinion, f64", "limit-zero, f64"];

/// A C compiler that a user may have.
struct Tool {
    command: &'static str,
    /// what the C++ compiler of the same kind is called
    cpp: &'static str,
    /// what its version names: `gcc` is another compiler's name on some hosts
    version_contains: &'static str,
    /// package of Debian
    package: &'static str,
    /// the major version, for x86-64, that the table of options was measured with
    measured: &'static str,
}

const GCC: Tool = Tool {
    command: "gcc",
    cpp: "g++",
    version_contains: "Free Software Foundation",
    package: "gcc g++",
    measured: "12",
};
const CLANG: Tool =
    Tool { command: "clang", cpp: "clang++", version_contains: "clang version", package: "clang", measured: "14" };

/// Those that are there, in a plain run the first of them.
fn tools() -> Vec<Tool> {
    let is_there = |tool: &Tool| environment::has(tool.command, tool.version_contains, tool.package);
    [GCC, CLANG].into_iter().filter(is_there).take(environment::by_depth(1, 2, 2)).collect()
}

/// `count` of all levels, options or processors for the case of a number: each has its share of the cases, in both real
/// types, which follow each other. All of them with `AXGEN_EVERY_LEVEL`.
fn in_turn<T: Clone>(all: &[T], number: usize, count: usize) -> Vec<T> {
    let count = if environment::is_every_level() { all.len() } else { count };
    let start = (number + number / all.len()) * count;
    all.iter().cycle().skip(start % all.len()).take(count).cloned().collect()
}

/// The cases for what takes its time: a twelfth in an exhaustive run, a third with `AXGEN_EVERY_LEVEL`, else a few.
fn cases() -> Vec<Case> {
    let mut cases = in_both_real_types();
    // These next to the few: the levels of optimisation see all.
    let part = environment::by_depth(usize::MAX, 12, 3);
    let mut number = 0_usize;
    cases.retain(|case| {
        number += 1;
        number.is_multiple_of(part) || QUICK_CASES.contains(&title(case).as_str())
    });
    cases
}

/// Whether the table of options was measured with this version.
fn is_measured(tool: &Tool) -> bool {
    let version = environment::said(tool.command, "-dumpversion").unwrap_or_default();
    cfg!(target_arch = "x86_64") && version.trim().split('.').next() == Some(tool.measured)
}

/// The first inputs of a case and the reference's answers.
fn reference(case: &Case, count: usize) -> (Samples, Samples) {
    let inputs = case::inputs(case, count).unwrap_or_else(|mistake| panic!("{mistake}"));
    let outputs = engine::run(Engine::Reference, &case.axis, &case.block, &inputs);
    (inputs, outputs.unwrap_or_else(|failure| panic!("{}: {failure}", title(case))))
}
