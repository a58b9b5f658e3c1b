//! The two files of an axis in C.

use super::outline::{COMMENT_WIDTH, Group, Member, Outline};
use super::{File, Header, Legal, block_name, rendered, stem};
use crate::self_test::SelfTest;
use askama::Template;
use compiler::print::{self, Appearance, Names, Printer, c::LANGUAGE, comment};
use compiler::program::{Expr, Program, Type, Variable};
use portable::{Intrinsic, Literal, RealKind};

/// The comment at a file's top, then its body.
#[derive(Template)]
#[template(path = "c/header.h")]
struct CFile<'a, T: Template> {
    file: &'a str,
    axis: &'a Header,
    real: &'a str,
    body: T,
}

#[derive(Template)]
#[template(path = "c/header_body.h")]
struct CHeader<'a> {
    guard: String,
    blocks: &'a [CBlock<'a>],
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
    blocks: &'a [CBlock<'a>],
}

/// One block with its self-test.
struct CBlock<'a> {
    /// what all its names begin with
    prefix: String,
    /// what the names of the functions beside its self-test begin with
    name: &'static str,
    inputs: Vec<Member>,
    outputs: Vec<Member>,
    state: Vec<Member>,
    constants: Vec<Group>,
    init: String,
    step: String,
    /// what is certain of its range, and its measured response
    certificate: String,
    self_test: &'a SelfTest,
    /// the digest after each sample
    expected: Vec<String>,
    /// the inputs that are set once, by position
    switches: Vec<(usize, String)>,
    scales: [String; 2],
    /// the bits of every output and every part of the state
    watched: Vec<String>,
}

/// The header and the source of an axis.
pub(super) fn files(axis: &Header, blocks: &[Legal<'_>]) -> Vec<File> {
    let stem = stem(&axis.name);
    let (header, source) = (format!("{stem}.h"), format!("{stem}.c"));
    // A source file is one scope: where several blocks share it, the numbers of each have its name before theirs.
    let mut names = Names::new(&LANGUAGE);
    let prefix = |block: &Legal<'_>| if blocks.len() > 1 { block.program.block } else { "" };
    let constants: Vec<Vec<String>> =
        blocks.iter().map(|block| print::constants(&block.program, prefix(block), &mut names)).collect();
    let text = |(block, constants)| block_text(&axis.name, block, constants, names.clone());
    let texts: Vec<CBlock<'_>> = blocks.iter().zip(constants).map(text).collect();
    let (bits, suffix, nearly_half) = match axis.real {
        RealKind::F64 => (64, "", Literal::F64(portable::nearly_half())),
        RealKind::F32 => (32, "f", Literal::F32(portable::nearly_half())),
    };
    let real = LANGUAGE.ty(Type::Real, axis.real);
    let uses = |wanted: &[Intrinsic]| blocks.iter().any(|block| asks_for(&block.program, wanted));
    let source_body = CSource {
        header: &header,
        uses_magnitude: uses(&[Intrinsic::InRange, Intrinsic::Within]),
        uses_nearest: uses(&[Intrinsic::Nearest]),
        real,
        bits,
        suffix,
        nearly_half: (LANGUAGE.literal)(nearly_half),
        blocks: &texts,
    };
    let header_body = CHeader { guard: format!("{}_H", stem.to_ascii_uppercase()), blocks: &texts };
    vec![
        rendered(&header, "", &CFile { file: &header, axis, real, body: header_body }),
        rendered(&source, "", &CFile { file: &source, axis, real, body: source_body }),
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

fn block_text<'a>(axis: &str, block: &'a Legal<'_>, constants: Vec<String>, names: Names) -> CBlock<'a> {
    let (program, self_test) = (&*block.program, &block.block.self_test);
    let printer = &Printer::beside(program, &LANGUAGE, names, Some(constants));
    let outline = Outline { block, language: &LANGUAGE, printer, next_line: "\n * " };
    let word = |bits: &u64| match program.real {
        RealKind::F64 => format!("UINT64_C(0x{bits:016x})"),
        RealKind::F32 => format!("UINT32_C(0x{bits:08x})"),
    };
    let watched = |name: &str, variables: &[Variable], members: &[String]| -> Vec<String> {
        let bits = |(variable, member): (&Variable, &String)| match variable.ty {
            Type::Real => format!("{}_bits_of({name}.{member})", program.block),
            Type::I32 => format!("(uint32_t){name}.{member}"),
            Type::Bool | Type::U32 => format!("{name}.{member}"),
        };
        variables.iter().zip(members).map(bits).collect()
    };
    let names = printer.names();
    CBlock {
        prefix: block_name(axis, program.block),
        name: program.block,
        inputs: outline.inputs(),
        outputs: outline.outputs(),
        state: outline.state(),
        constants: outline.groups(Appearance::Declared),
        init: printer.body(&program.init, 1),
        step: printer.body(&program.step, 1),
        certificate: comment::wrapped(&block.block.certificate, COMMENT_WIDTH, outline.next_line),
        self_test,
        expected: self_test.expected.iter().map(word).collect(),
        switches: self_test.switches.iter().map(|(index, value)| (*index, (LANGUAGE.literal)(*value))).collect(),
        scales: self_test.scales.map(LANGUAGE.literal),
        watched: [watched("outputs", &program.outputs, &names.outputs), watched("state", &program.state, &names.state)]
            .concat(),
    }
}
