//! The three files of a block in C: its header, its source, its self-test.

mod header;
pub(super) mod names;
pub(super) mod runner;

use super::outline::{COMMENT_WIDTH, Group, Member, Outline};
use super::{File, Header, Legal, rendered};
use crate::self_test::SelfTest;
use askama::Template;
use compiler::print::{Appearance, Printer, c::LANGUAGE, comment};
use compiler::program::{Expr, Program, Type, Var, Variable};
use header::Macro;
use portable::{Intrinsic, Literal, RealKind};

/// The comment at a file's top, then its body.
#[derive(Template)]
#[template(path = "c/file.h")]
struct CFile<'a, T: Template> {
    file: &'a str,
    axis: &'a Header,
    block: &'static str,
    real: &'a str,
    body: T,
}

#[derive(Template)]
#[template(path = "c/header_body.h")]
struct CHeader<'a> {
    guard: String,
    /// what the names of macros and enumerators begin with
    names: String,
    real: &'a str,
    bits: usize,
    macros: Vec<Macro>,
    enumerations: Vec<Group>,
    block: &'a CBlock,
    self_test: &'a SelfTest,
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
    real: &'a str,
    bits: usize,
    /// what the numbers of this real type and the compilers' own functions for it end with
    suffix: &'a str,
    block: &'a CBlock,
    self_test: &'a SelfTest,
    /// the digest after each sample
    expected: Vec<String>,
    /// the inputs that are set once, by position
    switches: Vec<(usize, String)>,
    scales: [String; 2],
    /// the factor of noise that is a part from 0 to 1
    part: String,
    /// the bits of every output, and of every part of the state
    watched: Vec<String>,
}

/// A block.
struct CBlock {
    /// what the names that its caller sees begin with
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
    /// those of what stands apart
    constants_apart: Vec<Group>,
    init: String,
    /// what seldom runs, a function of its own; empty where `step` is one function
    any_cycle: String,
    step: String,
    /// what is certain of its range, and its measured response
    certificate: String,
}

/// The header, the source and the self-test of a block.
pub(super) fn files(axis: &Header, block: &Legal<'_>) -> Vec<File> {
    let (program, self_test) = (&*block.program, &block.block.self_test);
    let prefix = names::prefix(axis, program.block);
    let (header, source, test) = (format!("{prefix}.h"), format!("{prefix}.c"), format!("{prefix}_self_test.c"));
    let (bits, suffix, nearly_half) = match axis.real {
        RealKind::F64 => (64, "", Literal::F64(portable::nearly_half())),
        RealKind::F32 => (32, "f", Literal::F32(portable::nearly_half())),
    };
    let real = LANGUAGE.ty(Type::Real, axis.real);
    let printer = &Printer::new(program, &LANGUAGE, &prefix);
    let outline = &Outline { axis, block, language: &LANGUAGE, printer, next_line: "\n * " };
    let text = &listed(outline, &prefix);
    let header_body = CHeader {
        guard: format!("{}_H", prefix.to_ascii_uppercase()),
        names: prefix.to_ascii_uppercase(),
        real,
        bits,
        macros: header::macros(axis, block),
        enumerations: header::enumerations(outline),
        block: text,
        self_test,
    };
    let source_body = CSource {
        header: &header,
        uses_magnitude: program.has(&|part| {
            matches!(part, Expr::Intrinsic(Intrinsic::InRange | Intrinsic::Within, _)) && !part.is_about_zero()
        }),
        uses_is_zero: program.has(&Expr::is_about_zero),
        uses_nearest: program.asks_for(&[Intrinsic::Nearest]),
        real,
        suffix,
        nearly_half: (LANGUAGE.literal)(nearly_half),
        block: text,
    };
    let test_body = CSelfTest {
        header: &header,
        real,
        bits,
        suffix,
        block: text,
        self_test,
        expected: self_test.expected.iter().map(|digest| word(*digest, axis.real)).collect(),
        switches: self_test.switches.iter().map(|(index, value)| (*index, (LANGUAGE.literal)(*value))).collect(),
        scales: self_test.scales.map(LANGUAGE.literal),
        part: (LANGUAGE.literal)(crate::noise::part(axis.real)),
        watched: watched(program, printer, &prefix),
    };
    let block = program.block;
    vec![
        rendered(&header, "", &CFile { file: &header, axis, block, real, body: header_body }),
        rendered(&source, "", &CFile { file: &source, axis, block, real, body: source_body }),
        rendered(&test, "", &CFile { file: &test, axis, block, real, body: test_body }),
    ]
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
    let inside = Outline { next_line: "\n     * ", ..*outline };
    let [shared] = outline.groups([Appearance::Shared]);
    let of_step = |index: usize, appearance| (appearance == Appearance::Declared).then(|| stands_apart[index].into());
    let [constants, constants_apart] = inside.groups_in(of_step);
    CBlock {
        prefix: prefix.to_owned(),
        inputs: outline.inputs(),
        set: outline.set(),
        outputs: outline.outputs(),
        state: outline.state(),
        shared,
        constants,
        constants_apart,
        init: printer.body(&program.init, 1),
        any_cycle: printer.body(apart, 1),
        step: printer.body(&program.step, 1),
        certificate: comment::wrapped(&outline.block.block.certificate.lines, COMMENT_WIDTH, outline.next_line),
    }
}

/// A digest as wide as a real.
fn word(digest: u64, real: RealKind) -> String {
    match real {
        RealKind::F64 => format!("UINT64_C(0x{digest:016x})"),
        RealKind::F32 => format!("UINT32_C(0x{digest:08x})"),
    }
}

/// The bits of every output, then of every part of the state.
fn watched(program: &Program, printer: &Printer<'_>, prefix: &str) -> Vec<String> {
    let bits = |of: &str, variable: &Variable, member: &str| match variable.ty {
        Type::Real => format!("{prefix}_bits_of({of}.{member})"),
        Type::I32 => format!("(uint32_t){of}.{member}"),
        Type::Bool | Type::U32 => format!("{of}.{member}"),
    };
    let names = printer.names();
    let outputs = program.outputs.iter().zip(&names.outputs).map(|(output, name)| bits("outputs", output, name));
    let state = program.state.iter().zip(&names.state).map(|(state, name)| bits("state", state, name));
    outputs.chain(state).collect()
}
