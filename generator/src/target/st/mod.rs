//! The files of Structured Text: what they have in common, the comment at the top and a block as a dialect lists it; and the
//! targets `st` and `scl`, whose files have nothing else.
//!
//! Whatever implementations disagree on is not printed: see `docs/structured-text.md`.

pub(super) mod codesys;
pub(super) mod twincat;

use super::outline::{COMMENT_WIDTH, Group, Member, Outline};
use super::{File, Header, Legal, Unit, block_name, rendered, stem};
use askama::Template;
use compiler::print::st::{PLAIN, SCL};
use compiler::print::{Appearance, Language, Printer, comment};
use compiler::program::Type;
use portable::RealKind;

/// The comment at the top of an axis's file.
#[derive(Template)]
#[template(path = "st/origin.st")]
struct Origin<'a> {
    file: &'a str,
    axis: &'a Header,
    real: &'a str,
    /// what is certain of the blocks in the file, and their measured response; empty where there is no block
    certificate: String,
}

/// A block: declarations, numbers, statements.
struct StBlock {
    name: String,
    inputs: Vec<Member>,
    outputs: Vec<Member>,
    state: Vec<Member>,
    locals: Vec<Member>,
    /// numbers that stand in the statements
    inline: Vec<Group>,
    /// numbers that are declared
    declared: Vec<Group>,
    /// numbers that each cycle assigns anew
    assigned: Vec<Group>,
    body: String,
}

#[derive(Template)]
#[template(path = "st/file.st")]
struct PlainFile<'a> {
    origin: Origin<'a>,
    blocks: Vec<StBlock>,
}

#[derive(Template)]
#[template(path = "scl/file.scl")]
struct SclFile<'a> {
    origin: Origin<'a>,
    blocks: Vec<StBlock>,
}

/// The function that looks at a sample's exponent bits before it compares it: TwinCAT's file, of which CODESYS takes the parts.
#[derive(Template)]
#[template(path = "twincat/in_range.TcPOU")]
struct TcInRange<'a> {
    id: String,
    name: String,
    real: &'a str,
    /// the bit string of the same size
    word: &'a str,
    /// the exponent's bits
    exponent: &'a str,
}

/// The file of an axis for any compiler of the standard's second edition.
pub(super) fn plain(axis: &Header, blocks: &[Legal<'_>]) -> Vec<File> {
    let name = format!("{}.st", stem(&axis.name));
    let file = PlainFile { origin: origin(axis, &name, blocks), blocks: listings(axis, blocks, "", &PLAIN) };
    vec![rendered(&name, "", &file)]
}

/// The file of an axis for Siemens S7-1200 and S7-1500: an external source.
pub(super) fn scl(axis: &Header, blocks: &[Legal<'_>]) -> Vec<File> {
    let name = format!("{}.scl", stem(&axis.name));
    let file = SclFile { origin: origin(axis, &name, blocks), blocks: listings(axis, blocks, "FB_", &SCL) };
    vec![rendered(&name, "", &file)]
}

/// The blocks of an axis; a dialect puts a prefix before their names.
fn listings(axis: &Header, blocks: &[Legal<'_>], prefix: &str, dialect: &'static Language) -> Vec<StBlock> {
    let listing = |block: &Legal<'_>| {
        let printer = &Printer::new(&block.program, dialect);
        let outline = Outline { block, language: dialect, printer, next_line: "\n       " };
        StBlock {
            name: format!("{prefix}{}", block_name(&axis.name, block.program.block)),
            inputs: outline.inputs(),
            outputs: outline.outputs(),
            state: outline.state(),
            locals: outline.locals(),
            inline: outline.groups(Appearance::Inline),
            declared: outline.groups(Appearance::Declared),
            assigned: outline.groups(Appearance::Assigned),
            body: printer.body(&block.program.step, 0),
        }
    };
    blocks.iter().map(listing).collect()
}

/// The comment at the top of an axis's file, which holds these blocks.
fn origin<'a>(axis: &'a Header, file: &'a str, blocks: &[Legal<'_>]) -> Origin<'a> {
    let certificates: Vec<&String> = blocks.iter().flat_map(|block| &block.block.certificate).collect();
    let certificate = comment::wrapped(&certificates, COMMENT_WIDTH, "\n   ");
    Origin { file, axis, real: PLAIN.ty(Type::Real, axis.real), certificate }
}

/// The real types that a set uses.
fn real_types(units: &[Unit<'_>]) -> impl Iterator<Item = RealKind> {
    [RealKind::F64, RealKind::F32].into_iter().filter(|real| units.iter().any(|unit| unit.real == *real))
}
