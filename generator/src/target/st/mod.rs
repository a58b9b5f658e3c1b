//! The files of Structured Text: the common parts, which are the comment at the top and a block in the notation of a
//! dialect; and the targets `st` and `scl`, which have only these parts.
//!
//! Constructs that implementations interpret differently are not printed: see `docs/structured-text.md`.

pub(super) mod codesys;
mod dialect;
mod enumeration;
pub(super) mod listing;
mod self_test;
pub(super) mod twincat;

use super::{BlockIdentity, File, TargetBlock, Unit, block_name, rendered, with_self_test};
use askama::Template;
use compiler::legalise;
use dialect::{CODESYS, Dialect, SIEMENS, ST};
use enumeration::{Enumeration, enumerations};
pub(super) use listing::Listing;
use listing::{Origin, listing, origin};
use portable::RealKind;

#[derive(Template)]
#[template(path = "st/file.st")]
struct PlainFile<'a> {
    origin: Origin<'a>,
    block: &'a Listing,
}

#[derive(Template)]
#[template(path = "scl/file.scl")]
struct SclFile<'a> {
    origin: Origin<'a>,
    block: &'a Listing,
}

/// The named values of a signal.
#[derive(Template)]
#[template(path = "scl/enumeration.scl")]
struct SclEnumeration<'a> {
    file: &'a str,
    of: &'a Enumeration,
}

#[derive(Template)]
#[template(path = "scl/IMPORT.md")]
struct SclGuide;

/// The function that checks the exponent bits of a sample before it compares the sample: TwinCAT's file, of which CODESYS
/// uses parts.
#[derive(Template)]
#[template(path = "twincat/in_range.TcPOU")]
struct TcInRange<'a> {
    id: String,
    name: String,
    real: &'a str,
    /// the bit string of the same size
    word: &'a str,
    /// the exponent's bits
    exponent: &'a str,
}

/// What a name means that only Structured Text has: a signal of PLCopen, an output of a self-test, a number of a signal.
pub fn meanings(name: &str) -> Vec<String> {
    let of_block = legalise::meanings(name).into_iter();
    let of_block = of_block.map(|doc| format!("`{name}` of a block in twincat, codesys and scl: {doc}"));
    let of_test = self_test::OUTPUTS.into_iter().filter(|(output, _)| *output == name);
    let of_test = of_test.map(|(_, doc)| format!("output `{name}` of a self-test in Structured Text: {doc}"));
    let numbers = enumerations(["spindle"].iter()).into_iter().flat_map(|of| {
        let named = of.values.into_iter().filter(|value| value.name == name);
        named.map(move |value| format!("`{name}` = {}: {}. {}", value.number, value.doc, of.note)).collect::<Vec<_>>()
    });
    of_block.chain(of_test).chain(numbers).collect()
}

/// The files of a block for any compiler of the standard's second edition.
pub(super) fn plain(axis: &BlockIdentity, block: &TargetBlock<'_>) -> Vec<File> {
    both(axis, block, &listings(axis, block, &ST), &ST, "st", |origin, block| {
        rendered(origin.file, "", &PlainFile { origin, block })
    })
}

/// A block and its self-test in this target.
pub(super) fn called(axis: &str, block: &str, _: bool) -> [String; 2] {
    with_self_test(listing::name(axis, block, &ST))
}

/// A block and its self-test for Siemens.
pub(super) fn scl_called(axis: &str, block: &str, _: bool) -> [String; 2] {
    with_self_test(listing::name(axis, block, &SIEMENS))
}

/// The files of a block for Siemens S7-1200 and S7-1500: external sources.
pub(super) fn scl(axis: &BlockIdentity, block: &TargetBlock<'_>) -> Vec<File> {
    both(axis, block, &listings(axis, block, &SIEMENS), &SIEMENS, "scl", |origin, block| {
        rendered(origin.file, "", &SclFile { origin, block })
    })
}

/// The file that all axes share.
pub(super) fn scl_shared(units: &[Unit<'_>]) -> Vec<File> {
    let of_signal = |of: &Enumeration| {
        let file = &format!("axgen_{}.scl", of.signal);
        rendered(file, "", &SclEnumeration { file, of })
    };
    let mut files: Vec<File> = enumerations(block_names(units)).iter().map(of_signal).collect();
    files.push(rendered("IMPORT_SCL.md", "", &SclGuide));
    files
}

/// A block and its self-test.
fn listings(axis: &BlockIdentity, block: &TargetBlock<'_>, dialect: &Dialect) -> [Listing; 2] {
    [listing(axis, block, dialect), self_test::listing(axis, block, dialect)]
}

/// A block and its self-test in TwinCAT and in CODESYS, made once.
fn in_codesys<'b>(axis: &BlockIdentity, block: &'b TargetBlock<'_>) -> &'b [Listing; 2] {
    block.in_codesys.get_or_init(|| listings(axis, block, &CODESYS))
}

/// The file of a block, and that of its self-test.
fn both(
    axis: &BlockIdentity,
    block: &TargetBlock<'_>,
    [listing, test]: &[Listing; 2],
    dialect: &Dialect,
    extension: &str,
    file: impl Fn(Origin<'_>, &Listing) -> File,
) -> Vec<File> {
    let name = block_name(&axis.name, block.program.block);
    let of_block = format!("{name}.{extension}");
    let of_test = format!("{}.{extension}", self_test::name(&name));
    vec![
        file(origin(axis, &of_block, block, dialect).with_call(block, listing, dialect), listing),
        file(origin(axis, &of_test, block, dialect), test),
    ]
}

/// The names of all blocks of a set.
fn block_names<'u>(units: &'u [Unit<'_>]) -> impl Iterator<Item = &'u &'static str> {
    units.iter().flat_map(|unit| &unit.blocks)
}

/// The real types that a set uses.
fn real_types(units: &[Unit<'_>]) -> impl Iterator<Item = RealKind> {
    [RealKind::F64, RealKind::F32].into_iter().filter(|real| units.iter().any(|unit| unit.reals.contains(real)))
}
