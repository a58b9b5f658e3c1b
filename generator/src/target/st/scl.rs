//! The target `scl`: an external source of Siemens S7-1200 and S7-1500 for each axis.

use super::block::{listing, origin};
use super::dialect::SCL;
use crate::axis::Axis;
use crate::block::Block;
use crate::digest::seal;
use crate::render::SclFile;
use crate::target::{File, stem};
use askama::Template;

/// The file of an axis.
///
/// # Panics
/// If the template cannot be filled, which no input can bring about.
#[must_use]
pub fn files(axis: &Axis, blocks: &[Block]) -> Vec<File> {
    let stem = stem(&axis.name);
    let name = format!("{stem}.scl");
    let origin = origin(axis, &name, blocks);
    let blocks: Vec<_> = blocks
        .iter()
        .map(|block| listing(format!("FB_{stem}_{}", block.program.block), block, block.program.clone(), SCL))
        .collect();
    let file = SclFile { origin: &origin, blocks: &blocks };
    let text = file.render().expect("scl: the file's template is filled") + "\n";
    vec![File { name, text: seal(text) }]
}
