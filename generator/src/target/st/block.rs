//! A block as a dialect lists it: declarations, numbers, statements. What every file form has in common.

use crate::digest::NO_CHECKSUM;
use crate::render::{Origin, StBlock};
use crate::target::outline::{COMMENT_WIDTH, Outline};
use crate::target::{Header, Legal, VERSION, block_name};
use askama::Template;
use compiler::print::st::type_name;
use compiler::print::{Appearance, Language, Printer, comment};
use compiler::program::Type;

/// The origin and the blocks of a file that has all blocks of an axis, as its template takes them; a dialect puts a prefix
/// before the blocks' names.
pub(crate) fn listings(
    axis: &Header,
    file: &str,
    blocks: &[Legal<'_>],
    prefix: &str,
    dialect: &'static Language,
) -> (String, Vec<StBlock>) {
    let listing = |block: &Legal<'_>| {
        let name = format!("{prefix}{}", block_name(&axis.axis, block.program.block));
        listing(name, block, dialect)
    };
    (origin(axis, file, blocks), blocks.iter().map(listing).collect())
}

/// A block with the name that a file gives it.
pub(crate) fn listing(name: String, block: &Legal<'_>, dialect: &'static Language) -> StBlock {
    let printer = &Printer::new(&block.program, dialect);
    let outline = Outline { block, language: dialect, printer, next_line: "\n       " };
    StBlock {
        name,
        inputs: outline.inputs(),
        outputs: outline.outputs(),
        state: outline.state(),
        locals: outline.locals(),
        inline: outline.groups(Appearance::Inline),
        declared: outline.groups(Appearance::Declared),
        assigned: outline.groups(Appearance::Assigned),
        body: printer.body(&block.program.step, 0),
    }
}

/// The comment at the top of an axis's file, which holds these blocks.
pub(crate) fn origin(axis: &Header, file: &str, blocks: &[Legal<'_>]) -> String {
    let certificates: Vec<&String> = blocks.iter().flat_map(|block| &block.block.certificate).collect();
    let origin = Origin {
        file,
        version: VERSION,
        axis: &axis.axis,
        real: type_name(Type::Real, axis.real),
        cycle_time_ns: axis.cycle_time_ns,
        parameters_digest: &axis.parameters_digest,
        checksum: NO_CHECKSUM,
        certificate: &comment::wrapped(&certificates, COMMENT_WIDTH, "\n   "),
    };
    origin.render().expect("st: the comment at the top is filled")
}
