//! Random axes: the emitted C, many axes in one program, gives the bits of the reference. `AXGEN_RANDOM_AXES` is
//! another number of them.

use crate::boards::{Emitted, run_here};
use axgen_tests::environment::by_depth;
use axgen_tests::model::{random, subject};
use axgen_tests::random::rng::Rng;
use generator::axis::Axis;
use generator::blocks::{self, Designed};
use rayon::prelude::*;

const SEED: u64 = 20_261_123;
/// In short all that the stimulus of a runner does.
const SAMPLES: usize = 1000;
/// Axes of a program.
const BATCH: usize = 10;

/// The numbers of so many axes as `AXGEN_RANDOM_AXES` says, or as are usual.
pub fn numbers(usual: usize) -> Vec<usize> {
    let named = std::env::var("AXGEN_RANDOM_AXES").ok().and_then(|text| text.parse().ok());
    (0..named.unwrap_or(usual)).collect()
}

/// The axis of a set, with its number in its name: in the sets all are called X.
pub fn numbered(index: usize, set: &str) -> Designed {
    Designed::from(Axis { name: format!("X{index}"), ..subject::read(set).axis })
}

/// The runner of the block of a random axis that contains its other blocks; none: the axis has no block.
fn emitted(index: usize) -> Option<Emitted> {
    let designed = numbered(index, &random::parameters(&mut Rng::numbered(SEED, index)).set());
    let blocks = blocks::blocks(&designed).unwrap_or_else(|defect| panic!("axis {index}: {defect}"));
    Some(Emitted::of(&designed, blocks.last()?, SAMPLES))
}

#[test]
#[expect(clippy::print_stdout, reason = "a figure of the acceptance")]
fn random_axes_have_the_bits_of_the_reference() {
    let axes = numbers(by_depth(6, 15, 200));
    let batch = |batch: &[usize]| {
        let emitted: Vec<Emitted> = batch.iter().filter_map(|index| emitted(*index)).collect();
        let said = run_here(&emitted.iter().collect::<Vec<_>>());
        let is_right = |of: &&Emitted| {
            let begin = format!("{}: {SAMPLES} samples\nself-test: passed\n", of.prefix);
            let rest = said.split_once(&begin).map(|(_, rest)| rest);
            rest.is_some_and(|rest| rest.starts_with("digests of 1000 samples that differ: 0 of 1\n"))
        };
        let wrong: Vec<&str> = emitted.iter().filter(|of| !is_right(of)).map(|of| of.prefix.as_str()).collect();
        assert!(wrong.is_empty(), "seed {SEED}, {wrong:?}:\n{said}");
        emitted.len()
    };
    let run: usize = axes.par_chunks(BATCH).map(batch).sum();
    assert!(2 * run > axes.len(), "few axes have a block: {run}");
    println!("0 differing bits: {run} random axes with {SAMPLES} samples each, of {} drawn", axes.len());
}
