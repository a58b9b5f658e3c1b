//! The target `codesys`: PLCopen XML (tc6_0200) for each axis, and a file with the function that all of them call.

use super::block::listings;
use super::{real_types, twincat};
use crate::digest::NO_CHECKSUM;
use crate::render::{CodesysFile, CodesysInRange};
use crate::target::{File, Header, Legal, Unit, VERSION, rendered, stem};
use compiler::print::st::CODESYS;

/// The file of an axis.
pub(crate) fn files(axis: &Header, blocks: &[Legal<'_>]) -> Vec<File> {
    let stem = stem(&axis.axis);
    let name = format!("{stem}.xml");
    let (origin, blocks) = listings(axis, &name, blocks, "", &CODESYS);
    vec![rendered(name, "", &CodesysFile { origin: &origin, version: VERSION, name: &stem, blocks: &blocks })]
}

/// The file that all axes share.
pub(crate) fn shared(units: &[Unit<'_>]) -> Vec<File> {
    let functions: Vec<_> = real_types(units).map(twincat::in_range).collect();
    let name = "axgen_shared";
    let file = CodesysInRange { version: VERSION, name, checksum: NO_CHECKSUM, functions: &functions };
    vec![rendered(format!("{name}.xml"), "", &file)]
}
