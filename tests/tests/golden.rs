//! The golden cases: recorded bits against the reference, the interpreted program, the compiled C and the Structured
//! Text. A C compiler is all that this needs.

use axgen_tests::cases::{all, in_both_real_types, title};
use axgen_tests::environment::is_exhaustive;
use golden::case::{self, Case, VECTOR_SAMPLES};
use golden::compare::{Difference, compare};
use golden::csv;
use golden::engine::{self, ENGINES, Engine, Failure};
use golden::samples::{Samples, Shape};
use golden::shows::shown;
use portable::Literal;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// What the cases have to show, all of them together.
const ALL_SHOWN: [&str; 60] = [
    "DIRECT from v_motor",
    "DIRECT from v_direct",
    "INDIRECT",
    "SET_POINT",
    "CRIT_DAMPING order 1",
    "CRIT_DAMPING order 2",
    "CRIT_DAMPING order 3",
    "BUTTERWORTH order 1",
    "BUTTERWORTH order 2",
    "BUTTERWORTH order 3",
    "BESSEL order 1",
    "BESSEL order 2",
    "BESSEL order 3",
    "BANDPASS + NO_FILTER",
    "BANDPASS + ALLPASS",
    "ALLPASS + BANDPASS",
    "BANDPASS + BANDPASS",
    "three full stages",
    "weight above the cap",
    "limited above",
    "limited below",
    "limit 0",
    "limited to 0",
    "start in OFF",
    "start in ON",
    "start in DRYRUN",
    "gate opens",
    "gate is open",
    "gate closes in DRYRUN",
    "gate closes in OFF",
    "gate turns round",
    "DRYRUN while moving",
    "OFF while moving",
    "acts again after reset",
    "acts again after loss of position control",
    "fault 1",
    "fault 2",
    "fault 11",
    "fault 12",
    "fault 13",
    "acts again after fault 1",
    "acts again after fault 2",
    "acts again after fault 11",
    "acts again after fault 12",
    "acts again after fault 13",
    "task cycle is right",
    "bad sample: NaN",
    "bad sample: infinity",
    "bad sample: beyond the limit",
    "bad sample that no stage reads",
    "rest is exactly 0",
    "lowest f0",
    "highest f0",
    "cycle time 62.5 us",
    "cycle time 125 us",
    "cycle time 1000 us",
    "cycle time 2000 us",
    "cycle time 4000 us",
    "double precision",
    "single precision",
];

#[test]
fn every_case_is_as_recorded() {
    let differing: Vec<String> = all()
        .par_iter()
        .flat_map(|case| {
            let differing = case::verify(case).unwrap_or_else(|mistake| vec![mistake]);
            differing.into_iter().map(|file| format!("{}: {file}", title(case))).collect::<Vec<_>>()
        })
        .collect();
    assert!(differing.is_empty(), "{differing:#?}; if that is meant: `axgen golden record golden/cases/*`");
}

#[test]
fn the_cases_together_claim_to_show_everything() {
    let cases = all();
    let claimed: BTreeSet<&str> = cases.iter().flat_map(|case| &case.shows).map(String::as_str).collect();
    let wanted = BTreeSet::from(ALL_SHOWN);
    assert_eq!(claimed.difference(&wanted).collect::<Vec<_>>(), [&""; 0], "claimed, and not in the list of this test");
    assert_eq!(wanted.difference(&claimed).collect::<Vec<_>>(), [&""; 0], "no case shows it");
}

#[test]
fn every_case_shows_what_it_claims() {
    for case in all() {
        let inputs = inputs(&case, VECTOR_SAMPLES);
        let shown = shown(&case.axis, &inputs, &run(&case, Engine::Reference, &inputs));
        let missing: Vec<&String> = case.shows.iter().filter(|word| !shown.contains(*word)).collect();
        assert!(missing.is_empty(), "{}: {missing:?}", title(&case));
        assert!(!case.shows.is_empty() && !case.purpose.is_empty(), "{}: what is it for?", title(&case));
    }
}

#[test]
fn all_engines_give_the_same_bits() {
    let count = if is_exhaustive() { case::DIGEST_SAMPLES } else { 100_000 };
    in_both_real_types().par_iter().for_each(|case| {
        let inputs = inputs(case, count);
        let expected = run(case, Engine::Reference, &inputs);
        assert_eq!(expected.len(), count);
        for engine in ENGINES.into_iter().filter(|engine| *engine != Engine::Reference) {
            let difference = compare(&expected, &run(case, engine, &inputs));
            assert_eq!(difference, Difference { bits: 0, first: None }, "{}: {engine}", title(case));
        }
    });
}

#[test]
fn the_recorded_inputs_alone_give_the_recorded_outputs() {
    all().par_iter().for_each(|case| {
        let file = |name| std::fs::read_to_string(case.folder.join(name)).unwrap();
        let shape = |variables| Shape::of(variables, case.axis.real);
        let inputs = csv::read(&file("inputs.csv"), &shape(&case.block.program.inputs)).unwrap();
        let expected = csv::read(&file("outputs.csv"), &shape(&case.block.program.outputs)).unwrap();
        assert_eq!(expected.len(), VECTOR_SAMPLES);
        for engine in ENGINES.into_iter().filter(|engine| *engine != Engine::C) {
            let difference = compare(&expected, &run(case, engine, &inputs));
            assert_eq!(difference, Difference { bits: 0, first: None }, "{}: {engine}", title(case));
        }
    });
}

#[test]
fn golden_stays_small() {
    fn size(folder: &std::path::Path) -> u64 {
        let entries = std::fs::read_dir(folder).unwrap().map(Result::unwrap);
        entries
            .map(|entry| if entry.path().is_dir() { size(&entry.path()) } else { entry.metadata().unwrap().len() })
            .sum()
    }
    let bytes = size(&std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden"));
    assert!(bytes < 10_000_000, "golden/ holds {bytes} bytes");
}

/// The comparison itself: one bit of one sample is found, where it is.
#[test]
fn a_single_bit_is_found() {
    let case = all().remove(0);
    let inputs = inputs(&case, VECTOR_SAMPLES);
    let expected = run(&case, Engine::Reference, &inputs);
    let frame = expected.shape.frame();
    let mut found = expected.clone();
    found.bytes[1_234 * frame] ^= 0x10;
    let difference = compare(&expected, &found);
    let first = difference.first.unwrap();
    assert_eq!((difference.bits, first.sample, first.signal.as_str()), (1, 1_234, "v_add"));
    found.bytes.truncate(1_000 * frame);
    assert_eq!(
        compare(&expected, &found).bits,
        8 * (expected.bytes.len() - found.bytes.len()) as u64,
        "missing samples"
    );
}

/// Of every case: with its first coefficient off by one unit in the last place, the interpreter's bits differ, and the
/// compiled block does not pass its self-test.
#[test]
fn a_coefficient_that_is_off_by_one_bit_is_found() {
    in_both_real_types().par_iter().for_each(|case| {
        let mut case = case.clone();
        let constants = &mut case.block.program.constants;
        let coefficient = constants.iter_mut().find(|constant| constant.path.starts_with("stage")).unwrap();
        coefficient.value = match coefficient.value {
            Literal::F64(value) => Literal::F64(f64::from_bits(value.to_bits() ^ 1)),
            Literal::F32(value) => Literal::F32(f32::from_bits(value.to_bits() ^ 1)),
            other => panic!("{other:?} is no coefficient"),
        };
        let inputs = inputs(&case, VECTOR_SAMPLES);
        let expected = run(&case, Engine::Reference, &inputs);
        // A limit of 0 lets nothing through in which a difference could show.
        if case.axis.ipc.v_add_max_fact > 0 {
            assert!(compare(&expected, &run(&case, Engine::Program, &inputs)).bits > 0, "{}", title(&case));
        }
        let failure = engine::run(Engine::C, &case.axis, &case.block, &inputs);
        assert!(matches!(failure, Err(Failure::SelfTest(_))), "{}: {failure:?}", title(&case));
    });
}

fn inputs(case: &Case, count: usize) -> Samples {
    case::inputs(case, count).unwrap_or_else(|mistake| panic!("{mistake}"))
}

fn run(case: &Case, engine: Engine, inputs: &Samples) -> Samples {
    let outputs = engine::run(engine, &case.axis, &case.block, inputs);
    outputs.unwrap_or_else(|failure| panic!("{}: {engine}: {failure}", title(case)))
}
