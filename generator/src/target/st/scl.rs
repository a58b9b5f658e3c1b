//! The target `scl`: an external source of Siemens S7-1200 and S7-1500 for each axis.

use super::block::listings;
use crate::render::SclFile;
use crate::target::{File, Header, Legal, rendered, stem};
use compiler::print::st::SCL;

/// The file of an axis.
pub(crate) fn files(axis: &Header, blocks: &[Legal<'_>]) -> Vec<File> {
    let name = format!("{}.scl", stem(&axis.axis));
    let (origin, blocks) = listings(axis, &name, blocks, "FB_", &SCL);
    vec![rendered(name, "", &SclFile { origin: &origin, blocks: &blocks })]
}
