//! The target `twincat`: function blocks, their common files, and TcUnit suites, in the folders of a TwinCAT 3 PLC project.

mod project;
mod suite;

pub(crate) use project::shared;

use super::dialect::TWINCAT;
use super::listing::{self, Listing, Origin, SetType, origin};
use super::{TcInRange, in_codesys};
use crate::target::{self, BlockIdentity, File, TargetBlock, with_self_test};
use askama::Template;
use askama::filters::Escaper;
use compiler::print::st::CODESYS;
use compiler::program::Type;
use portable::RealKind;
use std::fmt::Write;
use uuid::{Uuid, uuid};

/// The folder of the files, below the output folder.
const FOLDER: &str = "twincat";
/// The folder of the objects that the machine runs.
const POUS: &str = "POUs";
/// The folder of its types.
const DUTS: &str = "DUTs";
/// The folder of the objects that only tests need.
const TESTS: &str = "Tests";

/// TwinCAT's files begin with a byte order mark.
const BYTE_ORDER_MARK: &str = "\u{feff}";

/// The namespace of all GUIDs that axgen makes: version 5 of the name `axgen` in RFC 9562's namespace of URLs. Another
/// namespace would give every object of every project another GUID.
const NAMESPACE: Uuid = uuid!("4af64489-b926-5bad-acb2-20dca8f42d6a");

/// A function block.
#[derive(Template)]
#[template(path = "twincat/block.TcPOU")]
struct TcPou<'a> {
    origin: Origin<'a>,
    id: String,
    block: &'a Listing,
}

/// The type of the parameter sets of a block.
#[derive(Template)]
#[template(path = "twincat/params.TcDUT")]
struct TcParams<'a> {
    origin: Origin<'a>,
    id: String,
    set: &'a SetType,
}

/// The files of a block: the function block, its self-test, a suite that runs that, and the type of its parameter
/// sets, if it takes any.
pub(crate) fn files(axis: &BlockIdentity, block: &TargetBlock<'_>) -> Vec<File> {
    let pou = |folder: &str, listing: &Listing, is_test: bool| {
        let file = format!("{}.TcPOU", listing.name);
        let origin = origin(axis, &file, block, &TWINCAT);
        let origin = if is_test { origin } else { origin.with_call(block, listing, &TWINCAT) };
        rendered(folder, &file, &TcPou { origin, id: guid("POU", &listing.name), block: listing })
    };
    let [listing, test] = in_codesys(axis, block);
    let set = listing.declared_set().map(|set| {
        let file = format!("{}.TcDUT", set.name);
        let template = TcParams { origin: origin(axis, &file, block, &TWINCAT), id: guid("DUT", &set.name), set };
        rendered(DUTS, &file, &template)
    });
    let files = [pou(POUS, listing, false), pou(TESTS, test, true), suite::file(axis, block)];
    files.into_iter().chain(set).collect()
}

/// A block and its self-test.
pub(crate) fn called(axis: &str, block: &str, _: bool) -> [String; 2] {
    with_self_test(block_name(axis, block))
}

/// The name of the function block of a block of an axis.
fn block_name(axis: &str, block: &str) -> String {
    listing::name(axis, block, &TWINCAT)
}

/// The bit string with the size of a real.
fn word_name(real: RealKind) -> &'static str {
    match real {
        RealKind::F64 => "LWORD",
        RealKind::F32 => "DWORD",
    }
}

/// The function that the statements call by this name.
pub(super) fn in_range(real: RealKind) -> TcInRange<'static> {
    let exponent = match real {
        RealKind::F64 => "16#7FF0000000000000",
        RealKind::F32 => "16#7F800000",
    };
    let (real, word) = (CODESYS.ty(Type::Real, real), word_name(real));
    let name = format!("F_axgen_in_range_{real}");
    TcInRange { id: guid("POU", &name), name, real, word, exponent }
}

/// The GUID of an object of some kind, in braces: version 5 of `KIND NAME`, so that it is equal in every run.
pub fn guid(kind: &str, name: &str) -> String {
    Uuid::new_v5(&NAMESPACE, format!("{kind} {name}").as_bytes()).braced().to_string()
}

fn rendered(folder: &str, file: &str, template: &impl Template) -> File {
    target::rendered(&format!("{FOLDER}/{folder}/{file}"), BYTE_ORDER_MARK, template)
}

/// The escaper of TwinCAT's files: only the end mark of a CDATA section has to be split.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cdata;

impl Escaper for Cdata {
    fn write_escaped_str<W: Write>(&self, mut to: W, text: &str) -> std::fmt::Result {
        // Most texts have no bracket, and this is found out sooner.
        if !text.contains(']') {
            return to.write_str(text);
        }
        let mut pieces = text.split("]]>");
        to.write_str(pieces.next().unwrap_or_default())?;
        pieces.try_for_each(|piece| {
            to.write_str("]]]]><![CDATA[>")?;
            to.write_str(piece)
        })
    }
}
