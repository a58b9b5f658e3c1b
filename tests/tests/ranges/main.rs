//! What the range analysis shows: of every golden case all that it should, of ten planted defects none; and what runs
//! from any state stays within what was shown.

#![expect(clippy::cast_possible_truncation, reason = "random bits")]

mod planted;
mod sound;

use axgen_tests::environment::by_depth;
use axgen_tests::model::{random, subject};
use axgen_tests::random::rng::Rng;
use generator::blocks::{BlockKind, Designed, of_axis};
use golden::case;
use rayon::prelude::*;
use std::path::Path;

const SEED: u64 = 20_261_124;

/// Of every golden case its axis, with its blocks.
fn subjects() -> Vec<(String, Designed, &'static dyn BlockKind)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden/cases");
    let mut subjects = Vec::new();
    for folder in case::folders(&root).expect("the cases") {
        let designed = case::axis(&folder).expect("the axis of a case");
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        for kind in of_axis(&designed.axis) {
            subjects.push((format!("{name}, {}", kind.name()), designed.clone(), kind));
        }
    }
    subjects
}

#[test]
fn every_golden_case_is_shown() {
    let subjects = subjects();
    assert!(subjects.len() > 50, "{} blocks", subjects.len());
    for (name, designed, kind) in subjects {
        let shown = kind.shown(&designed).expect("a program");
        assert!(shown.findings.is_empty(), "{name}: {:#?}", shown.findings);
    }
}

/// Of the independent model's axes.
#[test]
#[expect(clippy::print_stdout, reason = "a figure of the acceptance")]
fn random_axes_are_shown() {
    let axes = by_depth(200, 1_000, 10_000);
    let blocks_of = |index: usize| {
        let designed = subject::read(&random::parameters(&mut Rng::numbered(SEED, index)).set());
        let shown = of_axis(&designed.axis).map(|kind| {
            let shown = kind.shown(&designed).expect("a program");
            assert!(shown.findings.is_empty(), "axis {index}, {}: {:#?}", kind.name(), shown.findings);
        });
        shown.count()
    };
    let blocks: usize = (0..axes).into_par_iter().map(blocks_of).sum();
    assert!(blocks > axes, "few blocks: {blocks}");
    println!("{blocks} blocks of {axes} random axes are shown");
}
