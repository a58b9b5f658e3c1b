//! The target `st`: one file for each axis, for any compiler of the standard's second edition.

use super::block::{listing, origin};
use super::dialect::PLAIN;
use crate::axis::Axis;
use crate::block::Block;
use crate::digest::seal;
use crate::render::PlainFile;
use crate::target::{File, stem};
use askama::Template;

/// The file of an axis.
///
/// # Panics
/// If the template cannot be filled, which no input can bring about.
#[must_use]
pub fn files(axis: &Axis, blocks: &[Block]) -> Vec<File> {
    let stem = stem(&axis.name);
    let name = format!("{stem}.st");
    let origin = origin(axis, &name, blocks);
    let blocks: Vec<_> = blocks
        .iter()
        .map(|block| listing(format!("{stem}_{}", block.program.block), block, block.program.clone(), PLAIN))
        .collect();
    let file = PlainFile { origin: &origin, blocks: &blocks };
    let text = file.render().expect("st: the file's template is filled") + "\n";
    vec![File { name, text: seal(text) }]
}
