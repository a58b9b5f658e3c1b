//! The two files of an axis in C: what goes into the templates.

use super::names::is_reserved;
use super::print::{self, Printer, member};
use super::types;
use crate::axis::Axis;
use crate::blocks::Block;
use crate::digest::{UNSEALED, digest};
use crate::render::{CBlock, CFile, CHeader, CSelfTest, CSource, Noisy, Switch};
use crate::target::names::Names;
use crate::target::outline::{COMMENT_WIDTH, Language};
use crate::target::{File, VERSION, block_name, comment, sealed, stem};
use askama::Template;
use compiler::program::{Expr, Program, Type, Variable};
use portable::{Intrinsic, Literal, RealKind};

/// The header and the source of an axis.
///
/// # Panics
/// If a template cannot be filled, which no input can bring about.
#[must_use]
pub fn files(axis: &Axis, blocks: &[Block]) -> Vec<File> {
    let stem = stem(&axis.name);
    let (header, source) = (format!("{stem}.h"), format!("{stem}.c"));
    // A source file is one scope: where several blocks share it, the numbers of each have its name before theirs.
    let mut names = Names::without(is_reserved);
    let prefix = |block: &Block| if blocks.len() > 1 { block.program.block } else { "" };
    let constants: Vec<Vec<String>> =
        blocks.iter().map(|block| print::constants(&block.program, prefix(block), &mut names)).collect();
    let text = |(block, constants): (&Block, Vec<String>)| {
        block_text(&axis.name, block, &Printer::beside(&block.program, constants, names.clone()))
    };
    let texts: Vec<CBlock> = blocks.iter().zip(constants).map(text).collect();
    let guard = format!("{}_H", stem.to_ascii_uppercase());
    let header_body = CHeader { guard: &guard, blocks: &texts }.render().expect("c: the header's template is filled");
    let (zero, [builtin_magnitude, builtin_copysign], nearly_half) = match axis.real {
        RealKind::F64 => ("0.0", ["__builtin_fabs", "__builtin_copysign"], Literal::F64(portable::nearly_half())),
        RealKind::F32 => ("0.0f", ["__builtin_fabsf", "__builtin_copysignf"], Literal::F32(portable::nearly_half())),
    };
    let real = types::name(Type::Real, axis.real);
    let uses = |wanted: &[Intrinsic]| blocks.iter().any(|block| asks_for(&block.program, wanted));
    let source_body = CSource {
        header: &header,
        uses_magnitude: uses(&[Intrinsic::Usable, Intrinsic::Within]),
        uses_nearest: uses(&[Intrinsic::Nearest]),
        real,
        zero,
        nearly_half: types::literal(nearly_half),
        builtin_magnitude,
        builtin_copysign,
        blocks: &texts,
    };
    let source_body = source_body.render().expect("c: the source's template is filled");
    vec![with_origin(axis, header, &header_body), with_origin(axis, source, &source_body)]
}

/// Whether a program asks for one of these operations.
fn asks_for(program: &Program, wanted: &[Intrinsic]) -> bool {
    let mut found = false;
    for statement in program.init.iter().chain(&program.step) {
        statement.expressions(&mut |expr| {
            expr.parts(&mut |part| {
                found |= matches!(part, Expr::Intrinsic(intrinsic, _) if wanted.contains(intrinsic));
            });
        });
    }
    found
}

/// Puts the comment that names the origin on top.
fn with_origin(axis: &Axis, file: String, body: &str) -> File {
    let text = CFile {
        file: &file,
        version: VERSION,
        axis: &axis.name,
        real: types::name(Type::Real, axis.real),
        cycle_time_ns: axis.cycle_time_ns,
        parameters_digest: &digest(axis.canonical.as_bytes()),
        body_digest: UNSEALED,
        body,
    };
    sealed(file.clone(), "", &text)
}

fn block_text(axis: &str, block: &Block, printer: &Printer<'_>) -> CBlock {
    let program = &block.program;
    let prefix = block_name(axis, program.block);
    let language = Language { ty: &|ty| types::name(ty, program.real), literal: &types::literal, next_line: "\n * " };
    CBlock {
        inputs: language.inputs(program, &members(&program.inputs)),
        outputs: language.outputs(program, &members(&program.outputs)),
        state: language.members(&program.state, &members(&program.state)),
        constants: language.groups(block, program, printer.constants()),
        init: printer.body(&program.init),
        step: printer.body(&program.step),
        certificate: comment::wrapped(&block.certificate, COMMENT_WIDTH, "\n * "),
        samples: block.self_test.expected.len(),
        self_test: self_test(&prefix, block),
        prefix,
    }
}

/// The names of variables as members of a struct.
fn members(variables: &[Variable]) -> Vec<String> {
    variables.iter().map(|variable| member(&variable.path)).collect()
}

fn self_test(prefix: &str, block: &Block) -> String {
    let (program, test) = (&block.program, &block.self_test);
    let word = |bits: &u64| match program.real {
        RealKind::F64 => format!("UINT64_C(0x{bits:016x})"),
        RealKind::F32 => format!("UINT32_C(0x{bits:08x})"),
    };
    let input = |index: &usize| member(&program.inputs[*index].path);
    let switch = |(index, value): &(usize, Literal)| Switch { name: input(index), value: types::literal(*value) };
    let noisy = |(sample, index): &(usize, usize)| Noisy { name: input(index), bad_sample: *sample };
    let watched = |name: &str, variables: &[Variable]| {
        let bits = |variable: &Variable| match (member(&variable.path), variable.ty) {
            (member, Type::Real) => format!("{}_bits_of({name}.{member})", program.block),
            (member, Type::I32) => format!("(uint32_t){name}.{member}"),
            (member, Type::Bool | Type::U32) => format!("{name}.{member}"),
        };
        variables.iter().map(bits).collect::<Vec<_>>()
    };
    let (turn, not_a_number, middle) = match program.real {
        RealKind::F64 => (59, "UINT64_C(0x7ff8000000000000)", "8388608.0"),
        RealKind::F32 => (27, "UINT32_C(0x7fc00000)", "8388608.0f"),
    };
    let text = CSelfTest {
        prefix,
        block: program.block,
        real: types::name(Type::Real, program.real),
        bits_type: types::bits_name(program.real),
        turn,
        expected: &test.expected.iter().map(word).collect::<Vec<_>>(),
        switches: &test.switches.iter().map(switch).collect::<Vec<_>>(),
        noisy: &test.bad.iter().map(noisy).collect::<Vec<_>>(),
        not_a_number,
        middle,
        scales: test.scales.map(types::literal),
        loud_from: test.loud_from,
        watched: &[watched("outputs", &program.outputs), watched("state", &program.state)].concat(),
    };
    text.render().expect("c: the self-test's template is filled")
}
