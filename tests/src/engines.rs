//! A run of a block through every engine: the bits of the reference. No inputs are made here.

use crate::environment::{by_depth, is_every_level};
use generator::blocks::{Block, Designed};
use golden::compare::{Difference, compare};
use golden::engine::{self, ENGINES, Engine};
use golden::samples::Samples;
use portable::RealKind;

/// Runs a block through every engine but the reference, whose outputs are `expected`.
///
/// What is compiled has all samples. What is interpreted takes a hundred times as long for a sample and has the first half
/// of them; the dialects of Structured Text, which differ in names and declarations, a quarter. All have all with
/// `AXGEN_EVERY_LEVEL`. The Rust, whose compiler takes longest, is left out of a plain run for single precision.
///
/// # Panics
/// If an engine does not run, or gives another bit.
pub fn agree(what: &str, designed: &Designed, block: &Block, inputs: &Samples, expected: &Samples) {
    for engine in ENGINES {
        let part = match engine {
            Engine::Reference => continue,
            Engine::Rust if by_depth(block.program.real == RealKind::F32, false, false) => continue,
            _ if is_every_level() => 1,
            Engine::C | Engine::Rust => 1,
            Engine::Program | Engine::St => 2,
            Engine::TwinCat | Engine::Codesys | Engine::Scl => 4,
        };
        let count = inputs.len().div_ceil(part);
        let found = engine::run(engine, designed, block, &inputs.first(count));
        let found = found.unwrap_or_else(|failure| panic!("{what}, {engine}: {failure}"));
        let difference = compare(&expected.first(count), &found);
        assert_eq!(difference, Difference { bits: 0, first: None }, "{what}, {engine}");
    }
}
