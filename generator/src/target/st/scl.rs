//! The target `scl`: an external source of Siemens S7-1200 and S7-1500 for each axis.

use super::block::listings;
use super::dialect::SCL;
use crate::axis::Axis;
use crate::blocks::Block;
use crate::render::SclFile;
use crate::target::{File, sealed, stem};

/// The file of an axis.
#[must_use]
pub fn files(axis: &Axis, blocks: &[Block]) -> Vec<File> {
    let name = format!("{}.scl", stem(&axis.name));
    let (origin, blocks) = listings(axis, &name, blocks, "FB_", SCL);
    vec![sealed(name, "", &SclFile { origin: &origin, blocks: &blocks })]
}
