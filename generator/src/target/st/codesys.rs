//! The target `codesys`: PLCopen XML (tc6_0200) for each axis, and a file with the function that all of them call.

use super::twincat::in_range;
use super::{Origin, StBlock, TcInRange, listings, origin, real_types};
use crate::target::{File, Header, Legal, Unit, rendered, stem};
use askama::Template;
use compiler::print::st::CODESYS;

#[derive(Template)]
#[template(path = "codesys/file.xml")]
struct CodesysFile<'a> {
    origin: Origin<'a>,
    name: &'a str,
    blocks: Vec<StBlock>,
}

/// The file that all axes share.
#[derive(Template)]
#[template(path = "codesys/in_range.xml")]
struct CodesysInRange<'a> {
    name: &'a str,
    /// one function for each real type
    functions: Vec<TcInRange<'a>>,
}

pub(crate) fn files(axis: &Header, blocks: &[Legal<'_>]) -> Vec<File> {
    let name = &stem(&axis.name);
    let file = format!("{name}.xml");
    let text = CodesysFile { origin: origin(axis, &file, blocks), name, blocks: listings(axis, blocks, "", &CODESYS) };
    vec![rendered(&file, "", &text)]
}

pub(crate) fn shared(units: &[Unit<'_>]) -> Vec<File> {
    let name = "axgen_shared";
    let text = CodesysInRange { name, functions: real_types(units).map(in_range).collect() };
    vec![rendered(&format!("{name}.xml"), "", &text)]
}
