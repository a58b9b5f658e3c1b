//! The target `codesys`: PLCopen XML (tc6_0200) for each axis, and a file with the function that all of them call.

use super::block::{listing, origin};
use super::dialect::{CODESYS, usable};
use crate::axis::Axis;
use crate::block::Block;
use crate::digest::{UNSEALED, seal};
use crate::render::{CodesysFile, CodesysUsable};
use crate::target::{File, Unit, stem};
use askama::Template;

/// The file of an axis.
///
/// # Panics
/// If the template cannot be filled, which no input can bring about.
#[must_use]
pub fn files(axis: &Axis, blocks: &[Block]) -> Vec<File> {
    let stem = stem(&axis.name);
    let name = format!("{stem}.xml");
    let origin = origin(axis, &name, blocks);
    let blocks: Vec<_> = blocks
        .iter()
        .map(|block| listing(format!("{stem}_{}", block.program.block), block, block.program.clone(), CODESYS))
        .collect();
    let file = CodesysFile { origin: &origin, version: env!("CARGO_PKG_VERSION"), name: &stem, blocks: &blocks };
    let text = file.render().expect("codesys: the file's template is filled") + "\n";
    vec![File { name, text: seal(text) }]
}

/// The file that all axes share.
///
/// # Panics
/// If the template cannot be filled, which no input can bring about.
#[must_use]
pub fn shared(units: &[Unit<'_>]) -> Vec<File> {
    let functions: Vec<_> = super::real_types(units).map(|real| super::twincat::usable(real, usable(real))).collect();
    let version = env!("CARGO_PKG_VERSION");
    let file = CodesysUsable { version, name: "axgen_shared", body_digest: UNSEALED, functions: &functions };
    let text = file.render().expect("codesys: the shared file's template is filled") + "\n";
    vec![File { name: "axgen_shared.xml".to_owned(), text: seal(text) }]
}
