//! A block as a dialect lists it: declarations, numbers, statements. What every file form has in common.

use super::dialect::{Dialect, Form, type_name};
use super::print::Printer;
use super::{nearest, operands, start, types};
use crate::axis::Axis;
use crate::blocks::Block;
use crate::digest::{UNSEALED, digest};
use crate::render::{Group, Member, Origin, StBlock};
use crate::target::outline::{COMMENT_WIDTH, Language};
use crate::target::{VERSION, block_name, comment};
use askama::Template;
use compiler::program::{Program, Type};

/// The origin and the blocks of a file that has all blocks of an axis, as its template takes them; a dialect puts a prefix
/// before the blocks' names.
#[must_use]
pub fn listings(axis: &Axis, file: &str, blocks: &[Block], prefix: &str, dialect: Dialect) -> (String, Vec<StBlock>) {
    let listing = |block: &Block| {
        let name = format!("{prefix}{}", block_name(&axis.name, block.program.block));
        listing(name, block, block.program.clone(), dialect)
    };
    (origin(axis, file, blocks), blocks.iter().map(listing).collect())
}

/// A block with the name that a file gives it.
#[must_use]
pub fn listing(name: String, block: &Block, program: Program, dialect: Dialect) -> StBlock {
    let emitted = nearest::run(start::run(program.clone()));
    let emitted = if dialect.has_digits_in_expressions(program.real) { emitted } else { operands::run(emitted) };
    let printer = Printer::new(&emitted, dialect);
    let language = Language { ty: &|ty| type_name(ty, program.real), literal: &types::literal, next_line: "\n       " };
    let names = &printer.names;
    let groups = language.groups(block, &emitted, &names.constants);
    let in_statements = Language { literal: &types::in_statement, ..language };
    let assigned = with_form(Form::Assigned, &printer.forms, &in_statements.groups(block, &emitted, &names.constants));
    let of = |form| with_form(form, &printer.forms, &groups);
    StBlock {
        name,
        inputs: language.inputs(&emitted, &names.inputs),
        outputs: language.outputs(&program, &names.outputs),
        state: language.members(&emitted.state, &names.state),
        locals: locals(&emitted, &names.locals),
        inline: of(Form::Inline),
        declared: of(Form::Declared),
        assigned,
        body: printer.body(0),
    }
}

/// The intermediate values; what they mean is said where they are computed.
fn locals(program: &Program, names: &[String]) -> Vec<Member> {
    let member = |(local, name): (&compiler::program::Local, &String)| Member {
        ty: type_name(local.ty.expect("st: the typing pass has typed every local"), program.real),
        name: name.clone(),
        doc: String::new(),
        start: String::new(),
    };
    program.locals.iter().zip(names).map(member).collect()
}

/// The constants of one form; `forms` has one for each, in the order of the groups.
fn with_form(wanted: Form, forms: &[Form], groups: &[Group]) -> Vec<Group> {
    let mut forms = forms.iter();
    let chosen = groups.iter().map(|group| Group {
        note: group.note.clone(),
        constants: group.constants.iter().filter(|_| forms.next() == Some(&wanted)).cloned().collect(),
    });
    chosen.filter(|group| !group.constants.is_empty()).collect()
}

/// The comment at the top of an axis's file, which holds these blocks.
#[must_use]
pub fn origin(axis: &Axis, file: &str, blocks: &[Block]) -> String {
    let certificates: Vec<&String> = blocks.iter().flat_map(|block| &block.certificate).collect();
    let origin = Origin {
        file,
        version: VERSION,
        axis: &axis.name,
        real: type_name(Type::Real, axis.real),
        cycle_time_ns: axis.cycle_time_ns,
        parameters_digest: &digest(axis.canonical.as_bytes()),
        body_digest: UNSEALED,
        certificate: &comment::wrapped(&certificates, COMMENT_WIDTH, "\n   "),
    };
    origin.render().expect("st: the comment at the top is filled")
}
