//! The target `codesys`: PLCopen XML (tc6_0200) for each block and for its self-test, and a file with their common parts.

use super::dialect::CODESYS;
use super::enumeration::{Enumeration, enumerations};
use super::listing::{self, Listing, Origin};
use super::twincat::in_range;
use super::{TcInRange, block_names, both, in_codesys, real_types};
use crate::target::{BlockIdentity, File, TargetBlock, Unit, rendered, with_self_test};
use askama::Template;

#[derive(Template)]
#[template(path = "codesys/file.xml")]
struct CodesysFile<'a> {
    origin: Origin<'a>,
    name: &'a str,
    block: &'a Listing,
}

/// The file that all axes share.
#[derive(Template)]
#[template(path = "codesys/shared.xml")]
struct CodesysShared<'a> {
    name: &'a str,
    enumerations: Vec<Enumeration>,
    /// one function for each real type
    functions: Vec<TcInRange<'a>>,
}

#[derive(Template)]
#[template(path = "codesys/IMPORT.md")]
struct CodesysGuide;

/// A block and its self-test.
pub(crate) fn called(axis: &str, block: &str, _: bool) -> [String; 2] {
    with_self_test(listing::name(axis, block, &CODESYS))
}

pub(crate) fn files(axis: &BlockIdentity, block: &TargetBlock<'_>) -> Vec<File> {
    both(axis, block, in_codesys(axis, block), &CODESYS, "xml", |origin, block| {
        rendered(origin.file, "", &CodesysFile { origin, name: &block.name, block })
    })
}

pub(crate) fn shared(units: &[Unit<'_>]) -> Vec<File> {
    let name = "axgen_shared";
    let text = CodesysShared {
        name,
        enumerations: enumerations(block_names(units)),
        functions: real_types(units).map(in_range).collect(),
    };
    vec![rendered(&format!("{name}.xml"), "", &text), rendered("IMPORT_CODESYS.md", "", &CodesysGuide)]
}
