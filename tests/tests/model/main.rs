//! The reference against the independent model, on random axes and random histories.

mod histories;

use axgen_tests::environment::by_depth;
use axgen_tests::model::agree::{self, Tally};
use axgen_tests::model::alone::{self, agree::Seen};
use axgen_tests::model::spindle::{self, Parameters, block};
use axgen_tests::random::rng::Rng;
use rayon::prelude::*;

/// Cycles of each set.
const CYCLES: usize = 1000;
const SEED: u64 = 20_261_122;

#[test]
fn the_reference_agrees_with_the_model_on_random_sets_of_1000_cycles() {
    let number = |name: &str, usual: u64| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual);
    let seed = number("AXGEN_MODEL_SEED", SEED);
    let sets = usize::try_from(number("AXGEN_MODEL_SETS", by_depth(200, 400, 1000))).expect("a number of sets");
    let run = |index| agree::set(seed, index, CYCLES);
    let (told, wrong): (Vec<_>, Vec<_>) = (0..sets).into_par_iter().map(run).partition(Result::is_ok);
    let told_of = wrong.iter().take(3).filter_map(|result| result.as_ref().err());
    let first: Vec<&str> = told_of.map(String::as_str).collect();
    assert!(wrong.is_empty(), "{} of {sets} sets disagree\n{}", wrong.len(), first.join("\n\n"));
    let mut tally = Tally::default();
    told.into_iter().flatten().for_each(|of_set| tally += of_set);
    eprintln!("{tally:?}");
    // Rounding must hardly ever leave a choice, else integers are not compared.
    assert!(tally.choices * 500 < tally.integers, "{tally:?}");
    assert!(tally.choices_in_single * 20 < tally.integers_in_single, "{tally:?}");
    assert!(tally.runs > 2 * sets as u64, "{tally:?}");
    assert!(tally.trips * 500 > sets as u64, "{tally:?}");
}

/// Cycles of each history of the changeover.
const SPINDLE_CYCLES: usize = 2000;

#[test]
fn the_changeover_agrees_with_its_model_on_random_histories_of_2000_cycles() {
    let differs = |seed: u64| {
        let p = Parameters::random(&mut Rng::new(SEED.wrapping_add(seed)));
        spindle::agree(&p, seed, SPINDLE_CYCLES, block::start(&p)).err()
    };
    let histories: u64 = by_depth(2_000, 4_000, 10_000);
    let wrong: Vec<String> = (0..histories).into_par_iter().filter_map(differs).collect();
    assert!(wrong.is_empty(), "{} of {histories} histories disagree\n{}", wrong.len(), wrong[0]);
}

/// Cycles of each axis with a block `ipc` that stands alone.
const ALONE_CYCLES: usize = 1500;

/// Ride-through, watch, tuned weights and parameter sets.
#[test]
fn the_block_ipc_agrees_with_its_model_whatever_the_caller_tunes() {
    let number = |name: &str, usual: u64| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual);
    let seed = number("AXGEN_MODEL_SEED", SEED);
    let count = usize::try_from(number("AXGEN_MODEL_SETS", by_depth(300, 800, 10_000))).expect("a number of axes");
    let run = |index| alone::agree::axis(seed, index, ALONE_CYCLES);
    let (seen, wrong): (Vec<_>, Vec<_>) = (0..count).into_par_iter().map(run).partition(Result::is_ok);
    let first: Vec<&str> =
        wrong.iter().take(2).filter_map(|result| result.as_ref().err()).map(String::as_str).collect();
    assert!(wrong.is_empty(), "{} of {count} axes disagree\n{}", wrong.len(), first.join("\n\n"));
    let mut all = Seen::default();
    seen.into_iter().flatten().for_each(|of_axis| all += of_axis);
    eprintln!("{all:?}");
    assert!(all.choices * 250 < all.flags, "rounding must hardly ever leave a choice: {all:?}");
    let each = [all.trips, all.held, all.taken, all.dropped, all.tuning].into_iter().chain(all.refused);
    assert!(each.min() >= Some(count as u64 / 4), "{all:?}");
}
