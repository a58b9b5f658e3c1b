//! Every case, in both real types, with every compiler at several levels: the bits of the reference. `AXGEN_EVERY_LEVEL=1` takes every level
//! and a million samples for each case.

use crate::{reference, tools};
use axgen_tests::cases::{in_both_real_types, title};
use axgen_tests::environment::{is_every_level, is_exhaustive};
use golden::case::{Case, DIGEST_SAMPLES};
use golden::compare::{Difference, compare};
use golden::engine::{Compiler, Harness};
use golden::samples::Samples;
use rayon::prelude::*;
use std::time::Instant;

/// The level that every case has; of the others each case has one, in turn. The engine `c` is the host's compiler with -O2.
const ALWAYS: [&[&str]; 1] = [&["-O0"]];
const IN_TURN: [&[&str]; 5] = [&["-O1"], &["-O3"], &["-O2"], &["-Os"], &["-O3", "-march=native", "-ffp-contract=off"]];
const QUICK_LEVELS: [&[&str]; 2] = [&["-O0"], &["-O3"]];
/// All that a stimulus does. The engine `c` has a million of each case (tests/tests/golden.rs).
const SAMPLES: usize = 100_000;
const QUICK_SAMPLES: usize = 20_000;

#[test]
#[expect(clippy::print_stdout, reason = "a figure of the acceptance")]
fn every_level_of_every_compiler_gives_the_bits_of_the_reference() {
    let begin = Instant::now();
    let is_deep = is_every_level();
    let count = match is_deep {
        true => DIGEST_SAMPLES,
        false if is_exhaustive() => SAMPLES,
        false => QUICK_SAMPLES,
    };
    let levels = |number: usize| match is_deep {
        true => [&ALWAYS[..], &IN_TURN].concat(),
        false if is_exhaustive() => [&ALWAYS[..], &IN_TURN[number % IN_TURN.len()..][..1]].concat(),
        false => QUICK_LEVELS.to_vec(),
    };
    let (cases, commands) = (in_both_real_types(), tools().into_iter().map(|tool| tool.command).collect::<Vec<_>>());
    let of_case = |(number, case): (usize, &Case)| {
        let (inputs, expected) = reference(case, count);
        let levels = levels(number);
        for command in &commands {
            every_level(case, command, &levels, &inputs, &expected);
        }
        commands.len() * levels.len()
    };
    let builds: usize = cases.par_iter().enumerate().map(of_case).sum();
    println!(
        "0 differing bits: {} blocks of {count} samples with {}; {builds} builds in {:.0} s",
        cases.len(),
        commands.join(" and "),
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
