//! The target `st`: one file for each axis, for any compiler of the standard's second edition.

use super::block::listings;
use super::dialect::PLAIN;
use crate::axis::Axis;
use crate::blocks::Block;
use crate::render::PlainFile;
use crate::target::{File, sealed, stem};

/// The file of an axis.
#[must_use]
pub fn files(axis: &Axis, blocks: &[Block]) -> Vec<File> {
    let name = format!("{}.st", stem(&axis.name));
    let (origin, blocks) = listings(axis, &name, blocks, "", PLAIN);
    vec![sealed(name, "", &PlainFile { origin: &origin, blocks: &blocks })]
}
