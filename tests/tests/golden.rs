//! The golden cases: recorded bits against the reference, the interpreted program, the compiled C and Rust and the Structured
//! Text. A C compiler and a Rust compiler are all that this needs.

use axgen_tests::cases::{all, in_both_real_types, title};
use axgen_tests::environment::{by_depth, is_every_level, is_exhaustive};
use golden::case::{self, Case, KEPT_SAMPLES};
use golden::compare::{Difference, compare};
use golden::csv;
use golden::engine::{self, ENGINES, Engine, Failure};
use golden::samples::{Samples, Shape};
use golden::shows::shown;
use golden::source::Source;
use portable::{Literal, RealKind};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// What the cases have to show, all of them together, one a line.
const ALL_SHOWN: &str = include_str!("shown.txt");

/// Files and recorded samples of every case; the digest of a million samples of one in 16, with `AXGEN_EVERY_LEVEL` of all.
#[test]
fn every_case_is_as_recorded() {
    let differing: Vec<String> = all()
        .par_iter()
        .enumerate()
        .flat_map(|(number, case)| {
            let is_whole = number.is_multiple_of(by_depth(16, 16, 1));
            let differing = if is_whole { case::verify(case) } else { case::verify_first(case) };
            let differing = differing.unwrap_or_else(|mistake| vec![mistake]);
            differing.into_iter().map(|file| format!("{}: {file}", title(case))).collect::<Vec<_>>()
        })
        .collect();
    assert!(differing.is_empty(), "{differing:#?}; if that is meant: `axgen golden record golden/cases/*`");
}

#[test]
fn the_cases_together_claim_to_show_everything() {
    let cases = all();
    let claimed: BTreeSet<&str> = cases.iter().flat_map(|case| &case.shows).map(String::as_str).collect();
    let wanted: BTreeSet<&str> = ALL_SHOWN.lines().collect();
    assert_eq!(claimed.difference(&wanted).collect::<Vec<_>>(), [&""; 0], "claimed, and not in shown.txt");
    assert_eq!(wanted.difference(&claimed).collect::<Vec<_>>(), [&""; 0], "no case shows it");
}

#[test]
fn every_case_shows_what_it_claims() {
    for case in all() {
        let inputs = vectors(&case);
        let shown = shown(&case.axis.axis, &inputs, &run(&case, Engine::Reference, &inputs));
        let missing: Vec<&String> = case.shows.iter().filter(|word| !shown.contains(*word)).collect();
        assert!(missing.is_empty(), "{}: {missing:?}", title(&case));
        assert!(!case.shows.is_empty() && !case.purpose.is_empty(), "{}: what is it for?", title(&case));
    }
}

/// Samples of a case in an engine. Every event of a stimulus is in the first 5,000, but for one that comes again after
/// 20,000 and one after 500,000. What needs more is a slow drift of rounding, the same in every engine: it has a million
/// samples in the reference and in C, in an exhaustive run for one case in 20. The dialects of
/// Structured Text differ in names and in their declarations.
fn samples(engine: Engine, number: usize) -> usize {
    let is_long = is_exhaustive() && number.is_multiple_of(20);
    match engine {
        _ if is_every_level() => case::DIGEST_SAMPLES,
        Engine::Reference | Engine::C if is_long => case::DIGEST_SAMPLES,
        Engine::Reference | Engine::C | Engine::Rust if is_exhaustive() => 25_000,
        Engine::TwinCat | Engine::Codesys | Engine::Scl => 5_000,
        Engine::Reference | Engine::C | Engine::Rust | Engine::Program | Engine::St => 6_000,
    }
}

/// Each case in both real types. The Rust, whose compiler takes longest, is compiled in one of them: for one case in two, in a
/// plain run for one in six. A plain run compiles C in the other one.
#[test]
fn all_engines_give_the_same_bits() {
    in_both_real_types().par_iter().enumerate().for_each(|(number, case)| {
        let count = samples(Engine::Reference, number);
        let all = inputs(case, count);
        let expected = run(case, Engine::Reference, &all);
        let is_stimulus = matches!(case.source, Source::Stimulus(_));
        assert_eq!(expected.len(), if is_stimulus { count } else { vectors(case).len() });
        let is_run = |engine: &Engine| match engine {
            Engine::Reference => false,
            Engine::Rust if is_every_level() => true,
            Engine::Rust => is_first_way(case) && (number / 2).is_multiple_of(by_depth(6, 3, 1)),
            Engine::C => is_exhaustive() || !is_first_way(case) && (number / 2).is_multiple_of(2),
            _ => true,
        };
        for engine in ENGINES.into_iter().filter(is_run) {
            let count = samples(engine, number);
            let difference = compare(&expected.first(count), &run(case, engine, &all.first(count)));
            assert_eq!(difference, Difference { bits: 0, first: None }, "{}: {engine}", title(case));
        }
    });
}

/// Which of two ways a case has; its twin in the other real type has the other one, and half of the cases in double
/// precision have either.
fn is_first_way(case: &Case) -> bool {
    (case.block.program.real == RealKind::F64) == title(case).len().is_multiple_of(2)
}

#[test]
fn the_recorded_inputs_alone_give_the_recorded_outputs() {
    all().par_iter().for_each(|case| {
        let file = |name| std::fs::read_to_string(case.folder.join(name)).unwrap();
        let shape = |variables| Shape::of(variables, case.block.program.real);
        let inputs = csv::read(&file("inputs.csv"), &shape(&case.block.program.inputs)).unwrap();
        let expected = csv::read(&file("outputs.csv"), &shape(&case.block.program.outputs)).unwrap();
        let is_stimulus = matches!(case.source, Source::Stimulus(_));
        assert_eq!(expected.len(), if is_stimulus { KEPT_SAMPLES } else { vectors(case).len() });
        for engine in ENGINES.into_iter().filter(|engine| ![Engine::C, Engine::Rust].contains(engine)) {
            let difference = compare(&expected, &run(case, engine, &inputs));
            assert_eq!(difference, Difference { bits: 0, first: None }, "{}: {engine}", title(case));
        }
    });
}

/// Function blocks of Structured Text have inputs and outputs in one scope.
#[test]
fn every_signal_of_a_block_has_a_name_of_its_own() {
    for case in all() {
        let program = &case.block.program;
        let names: Vec<&str> =
            program.inputs.iter().chain(&program.outputs).map(|signal| signal.path.as_str()).collect();
        assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len(), "{}: {names:?}", title(&case));
    }
}

#[test]
fn golden_stays_small() {
    fn size(folder: &std::path::Path) -> u64 {
        let entries = std::fs::read_dir(folder).unwrap().map(Result::unwrap);
        entries
            .map(|entry| if entry.path().is_dir() { size(&entry.path()) } else { entry.metadata().unwrap().len() })
            .sum()
    }
    let bytes = size(&std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden/cases"));
    assert!(bytes < 2_000_000, "golden/cases holds {bytes} bytes");
}

/// Of every case: with a coefficient off by one unit in the last place, the interpreter's bits differ, and the compiled block
/// does not pass its self-test: in one real type as C, in the other as Rust, in a plain run for one pair in five.
#[test]
fn a_coefficient_that_is_off_by_one_bit_is_found() {
    in_both_real_types().par_iter().enumerate().for_each(|(number, case)| {
        let mut case = case.clone();
        let constants = &mut case.block.program.constants;
        // One that reaches an output that is a real number: a part of a filter, else a weight, else a gain.
        // With parameter sets the fade is all that is left of it.
        let wanted = ["stage[", "velocity_delay.before", "weight_per_percent", "kv", "lag", "fade_step", "v_max"];
        let found = wanted.iter().find_map(|part| constants.iter().position(|constant| constant.path.contains(part)));
        // Of a spindle the turn, by which its position is wrapped: rounding hides a bit of what is added in a cycle.
        let found = found.or_else(|| constants.iter().position(|constant| constant.path == "full_turn"));
        let path = constants[found.expect("every block has one of them")].path.clone();
        let own = &mut case.block.for_axis.program.constants;
        for coefficient in constants.iter_mut().chain(own).filter(|constant| constant.path == path) {
            coefficient.value = match coefficient.value {
                Literal::F64(value) => Literal::F64(f64::from_bits(value.to_bits() ^ 1)),
                Literal::F32(value) => Literal::F32(f32::from_bits(value.to_bits() ^ 1)),
                other => panic!("{other:?} is no coefficient"),
            };
        }
        let inputs = vectors(&case);
        let expected = run(&case, Engine::Reference, &inputs);
        // A limit of 0 lets nothing through in which a difference could show, and an additive torque is an integer.
        let is_muted = case.block.program.block == "ipc" && case.axis.axis.ipc.v_add_max_fact == 0;
        let is_rounded = case.axis.axis.control.feedforward.as_ref().is_some_and(|feedforward| {
            case.block.program.block == "feedforward" && !feedforward.conventional.any() && !feedforward.additive.any()
        });
        // A set for single precision is rounded to it.
        let is_rounded = is_rounded || case.block.program.is_made_single;
        // A spindle that stays in position control computes nothing.
        let stays = case.shows.iter().any(|word| word == "stays in POSITION");
        if !is_muted && !is_rounded && !stays {
            assert!(compare(&expected, &run(&case, Engine::Program, &inputs)).bits > 0, "{}", title(&case));
        }
        // The self-test of a spindle need not turn it by a whole turn. That of an excitation in C and Rust never
        // starts it, for it holds the button from its first sample on: `verify` and the runner do.
        if ["spindle", "excitation"].contains(&case.block.program.block) || case.block.program.is_made_single {
            return;
        }
        let engines = match is_first_way(&case) {
            _ if is_every_level() => &[Engine::C, Engine::Rust][..],
            _ if !is_exhaustive() && !(number / 2).is_multiple_of(5) => &[],
            true => &[Engine::C],
            false => &[Engine::Rust],
        };
        for engine in engines.iter().copied() {
            let failure = engine::run(engine, &case.axis, &case.block, &inputs);
            assert!(matches!(failure, Err(Failure::SelfTest(_))), "{}: {engine}: {:?}", title(&case), failure.err());
        }
    });
}

fn vectors(case: &Case) -> Samples {
    case::vectors(case).unwrap_or_else(|mistake| panic!("{mistake}"))
}

fn inputs(case: &Case, count: usize) -> Samples {
    case::inputs(case, count).unwrap_or_else(|mistake| panic!("{mistake}"))
}

fn run(case: &Case, engine: Engine, inputs: &Samples) -> Samples {
    let outputs = engine::run(engine, &case.axis, &case.block, inputs);
    outputs.unwrap_or_else(|failure| panic!("{}: {engine}: {failure}", title(case)))
}
