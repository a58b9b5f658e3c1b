//! The exercise of `verify` reaches every part of every golden case's block: each input moves, each output changes, a
//! spindle passes through its states and transitions, parameter sets are taken over and refused. What a block cannot
//! reach is named here.

use axgen_tests::cases::{all, title};
use axgen_tests::environment::by_depth;
use golden::case::Case;
use golden::engine::{self, Engine};
use golden::exercise::{self, coverage::coverage};
use rayon::prelude::*;

/// As many as `axgen verify` has if nobody says it.
const SAMPLES: usize = 100_000;

/// A period takes ten times as long as the run: no stage reaches the limit in it.
const NOT_LIMITED: &str = "not among the outputs changed: limited";
const TOO_SLOW: [&str; 2] = ["lowest-frequency,", "single-precision-lowest-frequency,"];

#[test]
fn the_exercise_reaches_every_part_of_every_block() {
    // Cases that follow each other have one purpose often: of four of them a plain run has one.
    let cases: Vec<Case> = all().into_iter().step_by(by_depth(4, 3, 1)).collect();
    let missing: Vec<String> = cases
        .par_iter()
        .filter_map(|case| {
            let Case { axis, block, .. } = case;
            let inputs = exercise::inputs(axis, block, SAMPLES);
            let outputs = engine::run(Engine::Reference, axis, block, &inputs).unwrap();
            let reached = coverage(axis, block, &inputs, &outputs);
            let is_too_slow = TOO_SLOW.iter().any(|name| title(case).starts_with(name));
            let is_as_named = if is_too_slow { reached.missing().eq([NOT_LIMITED]) } else { reached.is_full() };
            let missing: Vec<String> = reached.missing().collect();
            (!is_as_named).then(|| format!("{}: {}", title(case), missing.join("; ")))
        })
        .collect();
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

/// A run that is too short names what it has not reached.
#[test]
fn a_short_exercise_says_what_it_has_not_reached() {
    let case = all().into_iter().find(|case| title(case).starts_with("parameter-sets,")).unwrap();
    let inputs = exercise::inputs(&case.axis, &case.block, 10);
    let outputs = engine::run(Engine::Reference, &case.axis, &case.block, &inputs).unwrap();
    let reached = coverage(&case.axis, &case.block, &inputs, &outputs);
    assert!(!reached.is_full());
    assert!(reached.to_string().ends_with("1 of 3 events of parameter sets"), "{reached}");
    let missing: Vec<String> = reached.missing().collect();
    assert_eq!(
        missing.last().unwrap(),
        "not among the events of parameter sets: a set taken over, another set taken over"
    );
}
