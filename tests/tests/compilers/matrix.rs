//! Every case, in both real types, at every level of every compiler: the bits of the reference.

use crate::{reference, tools};
use axgen_tests::cases::{in_both_real_types, title};
use axgen_tests::environment::is_exhaustive;
use golden::case::{Case, DIGEST_SAMPLES};
use golden::compare::{Difference, compare};
use golden::engine::{Compiler, Harness};
use golden::samples::Samples;
use rayon::prelude::*;
use std::time::Instant;

const LEVELS: [&[&str]; 6] =
    [&["-O0"], &["-O1"], &["-O2"], &["-O3"], &["-Os"], &["-O3", "-march=native", "-ffp-contract=off"]];
const QUICK_LEVELS: [&[&str]; 2] = [&["-O0"], &["-O3"]];
const QUICK_SAMPLES: usize = 20_000;

#[test]
#[expect(clippy::print_stdout, reason = "a figure of the acceptance")]
fn every_level_of_every_compiler_gives_the_bits_of_the_reference() {
    let begin = Instant::now();
    let (levels, count) =
        if is_exhaustive() { (&LEVELS[..], DIGEST_SAMPLES) } else { (&QUICK_LEVELS[..], QUICK_SAMPLES) };
    let (cases, commands) = (in_both_real_types(), tools().into_iter().map(|tool| tool.command).collect::<Vec<_>>());
    cases.par_iter().for_each(|case| {
        let (inputs, expected) = reference(case, count);
        for command in &commands {
            every_level(case, command, levels, &inputs, &expected);
        }
    });
    println!(
        "0 differing bits: {} blocks of {count} samples with {} at {}; {} builds in {:.0} s",
        cases.len(),
        commands.join(" and "),
        levels.iter().map(|level| level.join(" ")).collect::<Vec<_>>().join(", "),
        cases.len() * commands.len() * levels.len(),
        begin.elapsed().as_secs_f64(),
    );
}

fn every_level(case: &Case, command: &str, levels: &[&[&str]], inputs: &Samples, expected: &Samples) {
    let harness = Harness::compile(&case.axis, &case.block, &Compiler::new(command, &[]));
    let harness = harness.unwrap_or_else(|failure| panic!("{}: {command}: {failure}", title(case)));
    for level in levels {
        let what = format!("{}: {command} {level:?}", title(case));
        let found = harness.run(inputs, &Compiler::new(command, level));
        let found = found.unwrap_or_else(|failure| panic!("{what}: {failure}"));
        assert_eq!(compare(expected, &found), Difference { bits: 0, first: None }, "{what}");
    }
}
