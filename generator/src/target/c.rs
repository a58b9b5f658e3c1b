//! The two files of a block in C.

use super::outline::{COMMENT_WIDTH, Group, Member, Outline};
use super::{File, Header, Legal, block_name, rendered};
use crate::self_test::SelfTest;
use askama::Template;
use compiler::print::{Appearance, Printer, c::LANGUAGE, comment};
use compiler::program::{Expr, Program, Statement, Type, Variable};
use portable::{Intrinsic, Literal, RealKind};

/// The comment at a file's top, then its body.
#[derive(Template)]
#[template(path = "c/header.h")]
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
    block: &'a CBlock<'a>,
}

#[derive(Template)]
#[template(path = "c/source_body.c")]
struct CSource<'a> {
    header: &'a str,
    uses_magnitude: bool,
    uses_nearest: bool,
    real: &'a str,
    bits: usize,
    /// what the numbers of this real type and the compilers' own functions for it end with
    suffix: &'a str,
    nearly_half: String,
    block: &'a CBlock<'a>,
}

/// A block with its self-test.
struct CBlock<'a> {
    /// what the names that its caller sees begin with
    prefix: String,
    inputs: Vec<Member>,
    outputs: Vec<Member>,
    state: Vec<Member>,
    constants: Vec<Group>,
    enumerations: Vec<Group>,
    init: String,
    /// what seldom runs, a function of its own; empty where `step` is one function
    any_cycle: String,
    step: String,
    /// what is certain of its range, and its measured response
    certificate: String,
    self_test: &'a SelfTest,
    /// the digest after each sample
    expected: Vec<String>,
    /// the inputs that are set once, by position
    switches: Vec<(usize, String)>,
    scales: [String; 2],
    /// the bits of every output, and of every part of the state that is defined from the first sample on
    watched: Vec<String>,
}

/// The header and the source of a block.
pub(super) fn files(axis: &Header, block: &Legal<'_>) -> Vec<File> {
    let prefix = block_name(&axis.name, block.program.block);
    let (header, source) = (format!("{prefix}.h"), format!("{prefix}.c"));
    let (bits, suffix, nearly_half) = match axis.real {
        RealKind::F64 => (64, "", Literal::F64(portable::nearly_half())),
        RealKind::F32 => (32, "f", Literal::F32(portable::nearly_half())),
    };
    let real = LANGUAGE.ty(Type::Real, axis.real);
    let guard = format!("{}_H", prefix.to_ascii_uppercase());
    let text = block_text(axis, block, prefix);
    let source_body = CSource {
        header: &header,
        uses_magnitude: asks_for(&block.program, &[Intrinsic::InRange, Intrinsic::Within]),
        uses_nearest: asks_for(&block.program, &[Intrinsic::Nearest]),
        real,
        bits,
        suffix,
        nearly_half: (LANGUAGE.literal)(nearly_half),
        block: &text,
    };
    let header_body = CHeader { guard, block: &text };
    let block = block.program.block;
    vec![
        rendered(&header, "", &CFile { file: &header, axis, block, real, body: header_body }),
        rendered(&source, "", &CFile { file: &source, axis, block, real, body: source_body }),
    ]
}

/// Whether a program asks for one of these operations.
fn asks_for(program: &Program, wanted: &[Intrinsic]) -> bool {
    let mut found = false;
    for statement in program.statements() {
        statement.expressions(&mut |expr| {
            expr.parts(&mut |part| {
                found |= matches!(part, Expr::Intrinsic(intrinsic, _) if wanted.contains(intrinsic));
            });
        });
    }
    found
}

/// The statements that stand apart.
fn apart(list: &[Statement]) -> &[Statement] {
    let Some(last) = list.last() else { return &[] };
    match last {
        Statement::Apart(body) => body,
        Statement::If { otherwise, .. } => apart(otherwise),
        Statement::Note(_) | Statement::Assign { .. } | Statement::Choose { .. } => &[],
    }
}

fn block_text<'a>(axis: &'a Header, block: &'a Legal<'_>, prefix: String) -> CBlock<'a> {
    let (program, self_test) = (&*block.program, &block.block.self_test);
    let printer = &Printer::new(program, &LANGUAGE);
    let outline = Outline { axis, block, language: &LANGUAGE, printer, next_line: "\n * " };
    let word = |bits: &u64| match program.real {
        RealKind::F64 => format!("UINT64_C(0x{bits:016x})"),
        RealKind::F32 => format!("UINT32_C(0x{bits:08x})"),
    };
    let bits = |name: &str, variable: &Variable, member: &str| match variable.ty {
        Type::Real => format!("bits_of({name}.{member})"),
        Type::I32 => format!("(uint32_t){name}.{member}"),
        Type::Bool | Type::U32 => format!("{name}.{member}"),
    };
    let names = printer.names();
    let outputs = program.outputs.iter().zip(&names.outputs).map(|(output, name)| bits("outputs", output, name));
    let state = self_test.state.iter().map(|at| bits("state", &program.state[*at], &names.state[*at]));
    CBlock {
        prefix,
        inputs: outline.inputs(),
        outputs: outline.outputs(),
        state: outline.state(),
        constants: outline.groups(Appearance::Declared),
        enumerations: outline.groups(Appearance::Enumerator),
        init: printer.body(&program.init, 1),
        any_cycle: printer.body(apart(&program.step), 1),
        step: printer.body(&program.step, 1),
        certificate: comment::wrapped(&block.block.certificate, COMMENT_WIDTH, outline.next_line),
        self_test,
        expected: self_test.expected.iter().map(word).collect(),
        switches: self_test.switches.iter().map(|(index, value)| (*index, (LANGUAGE.literal)(*value))).collect(),
        scales: self_test.scales.map(LANGUAGE.literal),
        watched: outputs.chain(state).collect(),
    }
}
