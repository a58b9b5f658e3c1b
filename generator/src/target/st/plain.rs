//! The target `st`: one file for each axis, for any compiler of the standard's second edition.

use super::block::listings;
use crate::render::PlainFile;
use crate::target::{File, Header, Legal, rendered, stem};
use compiler::print::st::PLAIN;

/// The file of an axis.
pub(crate) fn files(axis: &Header, blocks: &[Legal<'_>]) -> Vec<File> {
    let name = format!("{}.st", stem(&axis.axis));
    let (origin, blocks) = listings(axis, &name, blocks, "", &PLAIN);
    vec![rendered(name, "", &PlainFile { origin: &origin, blocks: &blocks })]
}
