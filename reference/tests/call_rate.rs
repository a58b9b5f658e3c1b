//! The rate of the calls: what is tolerated, what is a fault, after how many calls, and what follows a pause. The numbers are
//! those of the document.
#![forbid(unsafe_code)]

use reference::call_rate::{Coeffs, State, is_usual, is_wrong, step};

const COUNTED: Coeffs = Coeffs { active: true };

/// The first call of a sequence, counted from 1, in which the rate is a fault; `None`: no fault within `calls`. No call may be
/// a pause.
fn first_fault(counters: impl Iterator<Item = u32>, calls: usize) -> Option<usize> {
    let mut state = State::default();
    counters
        .take(calls)
        .position(|counter| {
            assert!(!step(&mut state, counter), "{counter} is a pause");
            is_wrong(&state, &COUNTED)
        })
        .map(|at| at + 1)
}

/// The cycles without those for which something holds.
fn without(is_lost: impl Fn(u32) -> bool) -> impl Iterator<Item = u32> {
    (1..u32::MAX).filter(move |cycle| !is_lost(*cycle))
}

#[test]
fn wrong_rates_are_a_fault_after_the_stated_number_of_calls() {
    assert_eq!(first_fault(1.., 100_000), None, "once in each cycle");
    assert_eq!(
        first_fault((1..).flat_map(|cycle| [cycle; 2]), 100),
        Some(6),
        "twice in each cycle: in the third cycle"
    );
    assert_eq!(first_fault((1..).step_by(2), 100), Some(3), "in every second cycle: in the fifth cycle");
    assert_eq!(first_fault((1..).step_by(3), 100), Some(3), "in every third cycle: in the seventh cycle");
    assert_eq!(first_fault(without(|cycle| cycle % 4 == 0), 100), Some(10), "one in four is lost: in the 13th cycle");
}

/// The edge: one irregular call in nine is tolerated for good, one in eight is not.
#[test]
fn one_irregular_call_in_nine_is_tolerated() {
    let lost = |every: u32| move |cycle: u32| cycle.is_multiple_of(every);
    assert_eq!(first_fault(without(lost(10)), 1_000_000), None, "nine calls in ten cycles");
    assert_eq!(first_fault(without(lost(9)), 1000), Some(73), "eight calls in nine cycles: in the 82nd cycle");
    let doubled = |every: u32| (1..u32::MAX).flat_map(move |cycle| vec![cycle; if cycle % every == 0 { 2 } else { 1 }]);
    assert_eq!(first_fault(doubled(8), 1_000_000), None, "nine calls in eight cycles");
    assert_eq!(first_fault(doubled(7), 1000), Some(72), "eight calls in seven cycles: in the 63rd cycle");
}

#[test]
fn a_fault_ends_with_the_17th_regular_call_in_a_row() {
    let mut state = State::default();
    for counter in [1, 3, 5] {
        step(&mut state, counter);
    }
    let faulty = (6..).take_while(|counter| {
        step(&mut state, *counter);
        is_wrong(&state, &COUNTED)
    });
    assert_eq!(faulty.count(), 16);
}

/// One and two calls that are missing are no pause; three are, and so is a counter that restarts.
#[test]
fn from_three_missing_calls_on_it_is_a_pause() {
    let after = |last: u32, next: u32| {
        let mut state = State::default();
        step(&mut state, last);
        let has_paused = step(&mut state, next);
        assert!(!is_wrong(&state, &COUNTED), "one irregular call is not a fault");
        has_paused
    };
    assert_eq!([1000, 1001, 1002, 1003].map(|next| after(1000, next)), [false; 4]);
    assert_eq!([1004, 1005, 2000, 999, 1, u32::MAX].map(|next| after(1000, next)), [true; 6]);
    assert!(!after(u32::MAX - 1, 1), "the counter passes through 0: two calls are missing");
    assert!(after(u32::MAX - 2, 1), "three");
}

#[test]
fn a_counter_that_wraps_and_one_that_is_not_used_are_regular() {
    let mut state = State::default();
    for counter in (u32::MAX - 5..=u32::MAX).chain(0..20) {
        assert!(!step(&mut state, counter) && state.score == 0, "{counter}");
    }
    for counter in [0, 0, 7, 0, 900, 901] {
        assert!(!step(&mut state, counter) && state.score == 0, "{counter}");
    }
}

/// Every pattern of bits in the state: no overflow, and the score comes back.
#[test]
fn an_overwritten_state_does_no_harm() {
    let edges = [0, 1, 2, 7, 8, 15, 16, 31, 32, 33, 1000, 1 << 31, u32::MAX - 2, u32::MAX - 1, u32::MAX];
    let triples = (0..edges.len().pow(3))
        .map(|at| [at, at / edges.len(), at / edges.len().pow(2)].map(|at| edges[at % edges.len()]));
    for [expected, score, counter] in triples {
        let mut state = State { expected, score };
        let is_fast = is_usual(&state, &COUNTED, counter);
        let has_paused = step(&mut state, counter);
        assert!(state.score <= 32, "{expected} {score} {counter}");
        assert!(
            !is_fast || (!has_paused && state.score == 0),
            "{expected} {score} {counter}: the usual call is a regular one"
        );
        for cycle in 10..50 {
            step(&mut state, cycle);
        }
        assert!(!is_wrong(&state, &COUNTED), "{expected} {score} {counter}");
    }
}
