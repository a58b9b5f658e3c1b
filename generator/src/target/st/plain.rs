//! The target `st`: one file for each axis, for any compiler of the standard's second edition.

use super::{Origin, StBlock, listings, origin};
use crate::target::{File, Header, Legal, rendered, stem};
use askama::Template;
use compiler::print::st::PLAIN;

#[derive(Template)]
#[template(path = "st/file.st")]
struct PlainFile<'a> {
    origin: Origin<'a>,
    blocks: Vec<StBlock>,
}

pub(crate) fn files(axis: &Header, blocks: &[Legal<'_>]) -> Vec<File> {
    let name = format!("{}.st", stem(&axis.name));
    let file = PlainFile { origin: origin(axis, &name, blocks), blocks: listings(axis, blocks, "", &PLAIN) };
    vec![rendered(name.clone(), "", &file)]
}
