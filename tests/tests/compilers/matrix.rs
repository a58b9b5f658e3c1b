//! Every case, in both real types, with every compiler at one of its levels: the bits of the reference.
//! `AXGEN_EVERY_LEVEL=1` takes every level and a million samples for each case.

use crate::{in_turn, reference, tools};
use axgen_tests::cases::{in_both_real_types, title};
use axgen_tests::environment::{by_depth, is_every_level};
use golden::case::{Case, DIGEST_SAMPLES};
use golden::compare::{Difference, compare};
use golden::engine::{Compiler, Harness};
use golden::samples::Samples;
use rayon::prelude::*;

/// The engine `c`, which every case has, is the host's compiler with -O2.
const LEVELS: [&[&str]; 6] =
    [&["-O0"], &["-O3"], &["-Os"], &["-O1"], &["-O2"], &["-O3", "-march=native", "-ffp-contract=off"]];
/// In so many cycles a stimulus has shown all that it does, but for what a counter of 32 bits does at its end.
const SAMPLES: usize = 20_000;

#[test]
#[expect(clippy::print_stdout, reason = "a figure of the acceptance")]
fn every_level_of_every_compiler_gives_the_bits_of_the_reference() {
    let count = if is_every_level() { DIGEST_SAMPLES } else { SAMPLES };
    let (cases, commands) = (in_both_real_types(), tools().into_iter().map(|tool| tool.command).collect::<Vec<_>>());
    // All with AXGEN_EVERY_LEVEL, else an eighth of the cases with each compiler.
    let part = by_depth(8, 8, 1);
    let of_case = |(number, case): (usize, &Case)| {
        let (inputs, expected) = reference(case, count);
        let mut builds = 0;
        for (of, command) in commands.iter().enumerate().filter(|(of, _)| (number + of).is_multiple_of(part)) {
            let levels = in_turn(&LEVELS, number + LEVELS.len() / 2 * of, 1);
            every_level(case, command, &levels, &inputs, &expected);
            builds += levels.len();
        }
        builds
    };
    let builds: usize = cases.par_iter().enumerate().map(of_case).sum();
    println!(
        "0 differing bits: {} blocks of {count} samples with {}; {builds} builds",
        cases.len(),
        commands.join(" and "),
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
