//! The three files of a block in C: its header, its source, its self-test; and those that a user requests in addition.

pub(super) mod a2l;
mod exercise;
mod header;
pub(super) mod names;
pub(super) mod runner;

use super::outline::{COMMENT_WIDTH, Group, Member, Outline};
use super::{BlockIdentity, File, TargetBlock, bits, rendered};
use crate::blocks::IPC;
use crate::exercise::SelfTest;
use askama::Template;
use compiler::legalise::nearly_half;
use compiler::print::{Appearance, Printer, c::LANGUAGE, comment};
use compiler::program::{Expr, Program, Row, Statement, Type, Var};
use exercise::CExercise;
use header::Macro;
use portable::Intrinsic;

/// The comment at a file's top, then its body.
#[derive(Template)]
#[template(path = "c/file.h")]
struct CFile<'a, T: Template> {
    file: &'a str,
    axis: &'a BlockIdentity,
    block: &'static str,
    real: &'a str,
    body: T,
}

#[derive(Template)]
#[template(path = "c/header_body.h")]
struct CHeader<'a> {
    guard: String,
    /// the beginning of the names of macros and enumerators
    names: String,
    real: &'a str,
    bits: usize,
    macros: Vec<Macro>,
    enumerations: Vec<Group>,
    block: &'a CBlock,
    self_test: &'a SelfTest,
    /// the header with the type of the parameter set, if another block declares it
    header_of_set: Option<String>,
    /// that type
    shared_set: Option<String>,
}

#[derive(Template)]
#[template(path = "c/source_body.c")]
struct CSource<'a> {
    header: &'a str,
    uses_magnitude: bool,
    uses_is_zero: bool,
    uses_nearest: bool,
    real: &'a str,
    suffix: &'a str,
    nearly_half: String,
    block: &'a CBlock,
}

#[derive(Template)]
#[template(path = "c/self_test.c")]
struct CSelfTest<'a> {
    header: &'a str,
    block: &'a CBlock,
    self_test: &'a SelfTest,
    exercise: CExercise<'a>,
}

/// A block.
struct CBlock {
    /// the beginning of the names that its caller sees
    prefix: String,
    inputs: Vec<Member>,
    /// the parameter set, if it takes one
    set: Vec<Member>,
    outputs: Vec<Member>,
    state: Vec<Member>,
    /// the constants that both functions of a cycle read
    shared: Vec<Group>,
    /// those of `step`
    constants: Vec<Group>,
    /// constants of the separate function
    constants_apart: Vec<Group>,
    init: String,
    /// whether a slow task runs it
    is_slow: bool,
    /// when its caller calls it
    rate: &'static str,
    /// the rare part, as a separate function; empty if `step` is one function
    any_cycle: String,
    step: String,
    /// what it is for, and what its first call does
    purpose: String,
    /// its proven range, and its measured response
    certificate: String,
}

/// The header, the source and the self-test of a block.
pub(super) fn files(axis: &BlockIdentity, block: &TargetBlock<'_>) -> Vec<File> {
    let (program, self_test) = (&*block.program, &block.block.self_test);
    let prefix = names::prefix(axis, program.block);
    let header = &format!("{prefix}.h");
    let printer = &Printer::new(program, &LANGUAGE, &prefix);
    let outline = &Outline { axis, block, language: &LANGUAGE, printer, next_line: "\n * " };
    let block_text = &listed(outline, &prefix);
    let test_body = CSelfTest {
        header,
        block: block_text,
        self_test,
        exercise: exercise::of(block, printer, (&prefix, "&random"), &self_test.expected),
    };
    vec![
        file(outline, header, header_body(outline, block_text)),
        file(outline, &format!("{prefix}.c"), source_body(outline, block_text, header)),
        file(outline, &format!("{prefix}_self_test.c"), test_body),
    ]
}

fn file(outline: &Outline<'_>, file: &str, body: impl Template) -> File {
    let (axis, block) = (outline.axis, outline.block.program.block);
    let real = LANGUAGE.ty(Type::Real, axis.real);
    rendered(file, "", &CFile { file, axis, block, real, body })
}

fn header_body<'t>(outline: &Outline<'t>, block: &'t CBlock) -> CHeader<'t> {
    let axis = outline.axis;
    let names = block.prefix.to_ascii_uppercase();
    let shared = outline.block.block.shares_set().then(|| names::set(axis));
    CHeader {
        guard: format!("{names}_H"),
        names,
        real: LANGUAGE.ty(Type::Real, axis.real),
        bits: bits(axis.real),
        macros: header::macros(axis, outline.block),
        enumerations: header::enumerations(outline),
        block,
        self_test: &outline.block.block.self_test,
        header_of_set: shared.as_ref().map(|_| format!("{}.h", names::prefix(axis, IPC))),
        shared_set: shared,
    }
}

fn source_body<'t>(outline: &Outline<'_>, block: &'t CBlock, header: &'t str) -> CSource<'t> {
    let (program, real) = (&*outline.block.program, outline.axis.real);
    CSource {
        header,
        uses_magnitude: program.has(&|part| {
            matches!(part, Expr::Intrinsic(Intrinsic::InRange | Intrinsic::Within, _)) && !part.is_about_zero()
        }),
        uses_is_zero: program.has(&Expr::is_about_zero),
        uses_nearest: program.asks_for(&[Intrinsic::Nearest]),
        real: LANGUAGE.ty(Type::Real, real),
        suffix: exercise::suffix(real),
        nearly_half: (LANGUAGE.literal)(nearly_half(real)),
        block,
    }
}

/// The statements of `init`. Arrays of one length get a loop: the elements of each start with the same value.
fn init(program: &Program, printer: &Printer<'_>) -> String {
    let mut body = String::new();
    let mut lengths = Vec::new();
    for statement in &program.init {
        let row = match statement {
            Statement::Assign { target: Var::State(part), .. } => program.row_of(*part),
            _ => None,
        };
        let Some(Row { length, .. }) = row else {
            body += &printer.body(std::slice::from_ref(statement), 1);
            continue;
        };
        if lengths.contains(&length) {
            continue;
        }
        lengths.push(length);
        body += &format!("    for (uint32_t index = 0u; index < {length}u; ++index) {{\n");
        let start = |row: &Row| Statement::Assign {
            target: Var::State(row.first),
            value: Expr::Literal(program.state[row.first].start),
        };
        let starts: Vec<_> = program.rows.iter().filter(|row| row.length == length).map(start).collect();
        body += &printer.body(&starts, 2).replace("[0]", "[index]");
        body += "    }\n";
    }
    body
}

fn listed(outline: &Outline<'_>, prefix: &str) -> CBlock {
    let (printer, program) = (outline.printer, &*outline.block.program);
    let apart = program.apart();
    let mut stands_apart = vec![false; program.constants.len()];
    apart.iter().for_each(|statement| {
        statement.reads(&mut |var| {
            if let Var::Constant(index) = var {
                stands_apart[index] = true;
            }
        });
    });
    let list = |index: usize, appearance| match appearance {
        Appearance::Shared => Some(0),
        Appearance::Declared => Some(if stands_apart[index] { 2 } else { 1 }),
        Appearance::Inline | Appearance::Assigned | Appearance::Enumerator => None,
    };
    let inside = "\n     * ";
    let [shared, constants, constants_apart] = outline.groups_in(list, [outline.next_line, inside, inside]);
    CBlock {
        prefix: prefix.to_owned(),
        inputs: outline.inputs(),
        set: outline.set(),
        outputs: outline.outputs([names::set(outline.axis), String::new()]),
        state: outline
            .state(outline.parts_of_state(), |of, length| Member { name: format!("{}[{length}]", of.name), ..of }),
        shared,
        constants,
        constants_apart,
        init: init(program, printer),
        is_slow: program.made.is_some(),
        rate: outline.block.rate(),
        any_cycle: printer.body(apart, 1),
        step: printer.body(&program.step, 1),
        purpose: comment::wrapped(&[&outline.block.block.purpose], COMMENT_WIDTH, outline.next_line),
        certificate: comment::wrapped(&outline.block.block.certificate.lines, COMMENT_WIDTH, outline.next_line),
    }
}
