//! All states, and one test for each rule. What is explored and what a rule says is in `axgen_tests::exploration`.

use axgen_tests::exploration::rules::{RULES, Rule};
use axgen_tests::exploration::scenarios::{self, Scenario};
use axgen_tests::exploration::transitions::{NO_PAIR_IN_CNC, NOT_IN_CNC, Transition, possible, possible_pairs};
use axgen_tests::exploration::{Found, explore};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::io::Write;
use std::sync::LazyLock;

/// Longer than any shortest way; that it is not reached says that all states have been found.
const DEPTH: u32 = 100;

static FOUND: LazyLock<Vec<(Scenario, Found)>> = LazyLock::new(|| {
    let explored = |scenario: Scenario| {
        let found = explore(&scenario, DEPTH);
        (scenario, found)
    };
    let is_deep = std::env::var_os("AXGEN_DEEP_EXPLORATION").is_some();
    scenarios::all(is_deep).into_par_iter().map(explored).collect()
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

/// An exploration that finds nothing has looked at something: each rule has its test.
#[test]
fn every_rule_has_a_test() {
    let text = include_str!("exploration.rs");
    for rule in RULES {
        assert!(text.contains(&format!("assert_kept(Rule::{rule:?});")), "{rule:?}");
    }
}

#[track_caller]
fn assert_kept(rule: Rule) {
    for (scenario, found) in FOUND.iter() {
        if let Some((count, way)) = found.broken.get(&rule) {
            panic!("{rule:?}, broken {count} times by {}; a shortest way:\n{way}", scenario.name);
        }
    }
}

#[test]
fn only_listed_transitions_happen() {
    assert_kept(Rule::Listed);
}

#[test]
fn spindle_state_and_loop_closed_say_what_is() {
    assert_kept(Rule::Shown);
}

#[test]
fn x_spindle_is_within_a_turn() {
    assert_kept(Rule::Range);
}

#[test]
fn the_mode_asked_for_belongs_to_the_state() {
    assert_kept(Rule::Mode);
}

#[test]
fn no_position_command_is_obeyed_in_velocity() {
    assert_kept(Rule::Displayed);
}

#[test]
fn v_spindle_goes_down_by_the_deceleration_where_the_block_owns_it() {
    assert_kept(Rule::Ramp);
}

#[test]
fn x_spindle_goes_on_with_v_spindle_where_the_block_owns_it() {
    assert_kept(Rule::Advance);
}

#[test]
fn the_first_position_command_behind_brake_is_the_formulas() {
    assert_kept(Rule::Formula);
}

#[test]
fn the_step_at_the_take_over_is_within_the_window() {
    assert_kept(Rule::TakeOver);
}

#[test]
fn three_cycles_without_a_sample_are_coasted_and_the_fourth_stops() {
    assert_kept(Rule::Coasts);
}

#[test]
fn an_error_that_stays_begins_where_it_is_said() {
    assert_kept(Rule::Lasts);
}

#[test]
fn the_error_of_a_cycle_is_the_first_of_its_errors() {
    assert_kept(Rule::Errors);
}

#[test]
fn a_state_that_waits_ends_within_its_time() {
    assert_kept(Rule::Time);
}

#[test]
fn brake_ends_after_three_settled_cycles() {
    assert_kept(Rule::Settled);
}

#[test]
fn position_control_is_not_taken_up_with_a_command_above_voff() {
    assert_kept(Rule::SlowEnough);
}

#[test]
fn position_control_begins_at_the_start_after_three_slow_cycles_and_a_fast_spindle_is_caught() {
    assert_kept(Rule::Begins);
}

#[test]
fn a_drive_changes_to_position_control_slowly() {
    assert_kept(Rule::Obeys);
}

#[test]
fn the_velocity_command_of_the_start_is_not_against_the_spindle() {
    assert_kept(Rule::Forward);
}

#[test]
fn position_is_left_for_a_fast_turn_alone() {
    assert_kept(Rule::FastTurn);
}

#[test]
fn brake_begins_for_a_request_or_a_reset_alone() {
    assert_kept(Rule::Cause);
}

#[test]
fn a_reset_and_drive_off_clear_the_queue_and_stop_the_job() {
    assert_kept(Rule::ResetClears);
}

#[test]
fn a_reset_keeps_position() {
    assert_kept(Rule::ResetStays);
}

#[test]
fn a_reset_ends_velocity() {
    assert_kept(Rule::ResetBrakes);
}

#[test]
fn requests_count_and_are_served_in_their_order() {
    assert_kept(Rule::Order);
}

#[test]
fn no_job_behind_a_reset_is_lost() {
    assert_kept(Rule::JobKept);
}

#[test]
fn a_reset_leads_back_to_position_from_every_state() {
    assert_kept(Rule::Returns);
}

#[test]
fn every_state_settles_or_shows_an_error() {
    assert_kept(Rule::Settles);
}
