//! The target `scl`: an external source of Siemens S7-1200 and S7-1500 for each axis.

use super::{Origin, StBlock, listings, origin};
use crate::target::{File, Header, Legal, rendered, stem};
use askama::Template;
use compiler::print::st::SCL;

#[derive(Template)]
#[template(path = "scl/file.scl")]
struct SclFile<'a> {
    origin: Origin<'a>,
    blocks: Vec<StBlock>,
}

pub(crate) fn files(axis: &Header, blocks: &[Legal<'_>]) -> Vec<File> {
    let name = format!("{}.scl", stem(&axis.name));
    let file = SclFile { origin: origin(axis, &name, blocks), blocks: listings(axis, blocks, "FB_", &SCL) };
    vec![rendered(name.clone(), "", &file)]
}
