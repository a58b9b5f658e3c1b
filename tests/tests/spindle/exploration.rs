//! All states, and every rule in all of them. What is explored and what a rule says is in `axgen_tests::exploration`.

use axgen_tests::environment::by_depth;
use axgen_tests::exploration::scenarios::{self, Scenario};
use axgen_tests::exploration::transitions::{NO_PAIR_IN_CNC, NOT_IN_CNC, Transition, possible, possible_pairs};
use axgen_tests::exploration::{Found, explore};
use machine::velocity::Follows;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::io::Write;
use std::sync::LazyLock;

/// Longer than any shortest way; that it is not reached says that all states have been found.
const DEPTH: u32 = 100;

static FOUND: LazyLock<Vec<(Scenario, Found)>> = LazyLock::new(|| {
    let explored = |scenario: Scenario| {
        let found = explore(&scenario, DEPTH, by_depth(24, 1, 1));
        (scenario, found)
    };
    let is_deep = std::env::var_os("AXGEN_DEEP_EXPLORATION").is_some();
    let mut all = scenarios::all(is_deep);
    // Half of all cycles are those of weak drives, and of others that go off and on at any speed.
    let is_dear = |of: &Scenario| match of.model.follows {
        Follows::AtOnce => false,
        Follows::Weak(_) => true,
        _ => of.model.coasts,
    };
    all.retain(|scenario| by_depth(!is_dear(scenario), true, true));
    all.into_par_iter().map(explored).collect()
});

/// Past the capture of test output: what was visited is a result.
#[test]
fn every_state_is_visited_and_counted() {
    let mut text =
        String::from("spindle: states, cycles, transitions, pairs of transitions, depth of the last pair, depth\n");
    let mut sums = [0; 3];
    for (scenario, found) in FOUND.iter() {
        let passed: usize = found.transitions.values().sum();
        let numbers = [found.states, found.edges, passed, found.pairs.len()];
        let depths = (found.depth_of_pairs, found.depth);
        text += &format!("{numbers:?} {depths:?}: {}\n", scenario.name);
        sums.iter_mut().zip(numbers).for_each(|(sum, number)| *sum += number);
        assert!(found.depth < DEPTH, "{}: there are deeper states", scenario.name);
    }
    let _ = writeln!(std::io::stderr(), "{text}{sums:?} in all");
    assert!(sums[0] > 100_000, "{text}");
}

#[test]
fn every_transition_of_the_drive_is_visited() {
    assert_visited(true);
}

#[test]
fn every_transition_of_the_cnc_is_visited() {
    assert_visited(false);
}

fn assert_visited(in_drive: bool) {
    let of_kind = || FOUND.iter().filter(|(scenario, _)| scenario.in_drive == in_drive);
    let seen: BTreeSet<Transition> = of_kind().flat_map(|(_, found)| found.transitions.keys().copied()).collect();
    let listed: BTreeSet<Transition> = possible(in_drive).into_iter().collect();
    assert_eq!(seen, listed, "in_drive: {in_drive}; not in the CNC: {NOT_IN_CNC:?}");
}

#[test]
fn every_pair_of_transitions_of_the_drive_is_visited() {
    assert_pairs_visited(true);
}

#[test]
fn every_pair_of_transitions_of_the_cnc_is_visited() {
    assert_pairs_visited(false);
}

fn assert_pairs_visited(in_drive: bool) {
    let is_it = |scenario: &Scenario| scenario.in_drive == in_drive && scenario.remembers;
    let found = FOUND.iter().filter(|(scenario, _)| is_it(scenario));
    let pairs: BTreeSet<_> = found.flat_map(|(_, found)| found.pairs.iter().copied()).collect();
    let listed: BTreeSet<_> = possible_pairs(in_drive).into_iter().collect();
    let missing: Vec<_> = listed.difference(&pairs).collect();
    let surplus: Vec<_> = pairs.difference(&listed).collect();
    let all = (missing, surplus);
    assert_eq!(all, (Vec::new(), Vec::new()), "in_drive: {in_drive}; impossible are {NO_PAIR_IN_CNC:?}");
}

#[test]
fn every_rule_is_kept() {
    let broken: Vec<String> = FOUND
        .iter()
        .flat_map(|(scenario, found)| found.broken.iter().map(|(rule, broken)| (&scenario.name, rule, broken)))
        .map(|(name, rule, (count, way))| format!("{rule:?}, broken {count} times by {name}; a shortest way:\n{way}\n"))
        .collect();
    assert!(broken.is_empty(), "{}", broken.concat());
}
