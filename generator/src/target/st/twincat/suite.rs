//! A TcUnit suite for each block, which runs its self-test to the end.

use super::{TESTS, block_name, guid, rendered};
use crate::target::st::dialect::TWINCAT;
use crate::target::st::listing::{Origin, origin};
use crate::target::st::self_test;
use crate::target::{BlockIdentity, File, TargetBlock};
use askama::Template;

/// The suite of a block.
#[derive(Template)]
#[template(path = "twincat/suite.TcPOU")]
struct TcSuite<'a> {
    origin: Origin<'a>,
    id: String,
    method_id: String,
    name: &'a str,
    block: &'a str,
    self_test: &'a str,
    samples: usize,
}

pub(super) fn file(axis: &BlockIdentity, block: &TargetBlock<'_>) -> File {
    let name = &block_name(&axis.name, block.program.block);
    let suite = &suite_name(name);
    let file = format!("{suite}.TcPOU");
    let text = TcSuite {
        origin: origin(axis, &file, block, &TWINCAT),
        id: guid("POU", suite),
        method_id: guid("Method", suite),
        name: suite,
        block: name,
        self_test: &self_test::name(name),
        samples: block.block.trial.samples,
    };
    rendered(TESTS, &file, &text)
}

/// The name of the suite of a function block.
pub(super) fn suite_name(block: &str) -> String {
    format!("{block}_Test")
}
