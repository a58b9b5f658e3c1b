//! The target `twincat`: function blocks, what they share, and TcUnit suites, in the folders of a TwinCAT 3 PLC project.

mod guid;
mod project;
mod suite;

pub(crate) use project::shared;

use super::block::{listing, origin};
use crate::digest::NO_CHECKSUM;
use crate::render::{TcInRange, TcPou};
use crate::target::{self, File, Header, Legal, VERSION};
use askama::Template;
use compiler::print::st::{self, CODESYS, type_name};
use compiler::program::Type;
use portable::RealKind;

/// Where the files lie, below the output folder.
const FOLDER: &str = "twincat";
/// The folder of what the machine runs.
const POUS: &str = "POUs";
/// The folder of its types.
const DUTS: &str = "DUTs";
/// The folder of what only tests need.
const TESTS: &str = "Tests";

/// TwinCAT's files begin with a byte order mark.
const BYTE_ORDER_MARK: &str = "\u{feff}";

/// The files of an axis: for each block the function block, and a suite with its vector.
pub(crate) fn files(axis: &Header, blocks: &[Legal<'_>]) -> Vec<File> {
    blocks
        .iter()
        .flat_map(|block| {
            let name = block_name(&axis.axis, block.program.block);
            [function_block(axis, block, &name)].into_iter().chain(suite::files(axis, block, &name))
        })
        .collect()
}

/// The function block of a block.
fn function_block(axis: &Header, block: &Legal<'_>, name: &str) -> File {
    let file = format!("{name}.TcPOU");
    let listing = listing(name.to_owned(), block, &CODESYS);
    let pou = TcPou {
        origin: &origin(axis, &file, std::slice::from_ref(block)),
        id: &guid::derive("POU", name),
        block: &listing,
    };
    rendered(POUS, file, &pou)
}

/// The name of the function block of a block of an axis.
pub(crate) fn block_name(axis: &str, block: &str) -> String {
    format!("FB_{}", target::block_name(axis, block))
}

/// The bit string of a real's size.
fn word_name(real: RealKind) -> &'static str {
    match real {
        RealKind::F64 => "LWORD",
        RealKind::F32 => "DWORD",
    }
}

/// The function that looks at a sample's exponent bits before it compares it.
pub(crate) fn in_range(real: RealKind) -> TcInRange<'static> {
    let name = st::in_range(real);
    let exponent = match real {
        RealKind::F64 => "16#7FF0000000000000",
        RealKind::F32 => "16#7F800000",
    };
    let (real, word) = (type_name(Type::Real, real), word_name(real));
    TcInRange { version: VERSION, checksum: NO_CHECKSUM, id: guid::derive("POU", name), name, real, word, exponent }
}

/// A file from its template.
fn rendered(folder: &str, file: String, template: &impl Template) -> File {
    target::rendered(format!("{FOLDER}/{folder}/{file}"), BYTE_ORDER_MARK, template)
}
