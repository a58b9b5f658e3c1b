//! The two files of an axis in C: what goes into the templates.

use super::outline::{COMMENT_WIDTH, Outline};
use super::{File, Header, Legal, VERSION, block_name, rendered, stem};
use crate::digest::NO_CHECKSUM;
use crate::render::{CBlock, CFile, CHeader, CSelfTest, CSource, Noisy, Switch};
use askama::Template;
use compiler::print::c::LANGUAGE;
use compiler::print::{self, Appearance, Names, Printer, Scope, comment};
use compiler::program::{Expr, Program, Type, Variable};
use portable::{Intrinsic, Literal, RealKind};

/// The header and the source of an axis.
pub(super) fn files(axis: &Header, blocks: &[Legal<'_>]) -> Vec<File> {
    let stem = stem(&axis.axis);
    let (header, source) = (format!("{stem}.h"), format!("{stem}.c"));
    // A source file is one scope: where several blocks share it, the numbers of each have its name before theirs.
    let mut names = Names::new(&LANGUAGE);
    let prefix = |block: &Legal<'_>| if blocks.len() > 1 { block.program.block } else { "" };
    let constants: Vec<Vec<String>> =
        blocks.iter().map(|block| print::constants(&block.program, prefix(block), &mut names)).collect();
    let text = |(block, constants): (_, Vec<String>)| block_text(&axis.axis, block, constants, names.clone());
    let texts: Vec<CBlock> = blocks.iter().zip(constants).map(text).collect();
    let guard = format!("{}_H", stem.to_ascii_uppercase());
    let header_body = CHeader { guard: &guard, blocks: &texts }.render().expect("c: the header's template is filled");
    let (zero, [builtin_magnitude, builtin_copysign], nearly_half) = match axis.real {
        RealKind::F64 => ("0.0", ["__builtin_fabs", "__builtin_copysign"], Literal::F64(portable::nearly_half())),
        RealKind::F32 => ("0.0f", ["__builtin_fabsf", "__builtin_copysignf"], Literal::F32(portable::nearly_half())),
    };
    let real = real_name(axis.real);
    let uses = |wanted: &[Intrinsic]| blocks.iter().any(|block| asks_for(&block.program, wanted));
    let source_body = CSource {
        header: &header,
        uses_magnitude: uses(&[Intrinsic::InRange, Intrinsic::Within]),
        uses_nearest: uses(&[Intrinsic::Nearest]),
        real,
        zero,
        nearly_half: (LANGUAGE.literal)(nearly_half),
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
    for statement in program.statements() {
        statement.expressions(&mut |expr| {
            expr.parts(&mut |part| {
                found |= matches!(part, Expr::Intrinsic(intrinsic, _) if wanted.contains(intrinsic));
            });
        });
    }
    found
}

/// Puts the comment that names the origin on top.
fn with_origin(axis: &Header, file: String, body: &str) -> File {
    let text = CFile {
        file: &file,
        version: VERSION,
        axis: &axis.axis,
        real: real_name(axis.real),
        cycle_time_ns: axis.cycle_time_ns,
        parameters_digest: &axis.parameters_digest,
        checksum: NO_CHECKSUM,
        body,
    };
    rendered(file.clone(), "", &text)
}

fn real_name(real: RealKind) -> &'static str {
    (LANGUAGE.ty)(Type::Real, real)
}

fn block_text(axis: &str, block: &Legal<'_>, constants: Vec<String>, names: Names) -> CBlock {
    let program = &*block.program;
    let prefix = block_name(axis, program.block);
    let printer = &Printer::beside(program, &LANGUAGE, constants, names);
    let outline = Outline { block, language: &LANGUAGE, printer, next_line: "\n * " };
    CBlock {
        inputs: outline.inputs(),
        outputs: outline.outputs(),
        state: outline.state(),
        constants: outline.groups(Appearance::Declared),
        init: printer.body(&program.init, 1),
        step: printer.body(&program.step, 1),
        certificate: comment::wrapped(&block.block.certificate, COMMENT_WIDTH, outline.next_line),
        samples: block.block.self_test.expected.len(),
        self_test: self_test(&prefix, block, printer.names()),
        prefix,
    }
}

fn self_test(prefix: &str, block: &Legal<'_>, names: &Scope) -> String {
    let (program, test) = (&*block.program, &block.block.self_test);
    let word = |bits: &u64| match program.real {
        RealKind::F64 => format!("UINT64_C(0x{bits:016x})"),
        RealKind::F32 => format!("UINT32_C(0x{bits:08x})"),
    };
    let input = |index: &usize| names.inputs[*index].clone();
    let switch = |(index, value): &(usize, Literal)| Switch { name: input(index), value: (LANGUAGE.literal)(*value) };
    let noisy = |(sample, index): &(usize, usize)| Noisy { name: input(index), bad_sample: *sample };
    let watched = |name: &str, variables: &[Variable], members: &[String]| {
        let bits = |(variable, member): (&Variable, &String)| match (member, variable.ty) {
            (member, Type::Real) => format!("{}_bits_of({name}.{member})", program.block),
            (member, Type::I32) => format!("(uint32_t){name}.{member}"),
            (member, Type::Bool | Type::U32) => format!("{name}.{member}"),
        };
        variables.iter().zip(members).map(bits).collect::<Vec<_>>()
    };
    let (turn, bits_type, not_a_number, middle) = match program.real {
        RealKind::F64 => (59, "uint64_t", "UINT64_C(0x7ff8000000000000)", "8388608.0"),
        RealKind::F32 => (27, "uint32_t", "UINT32_C(0x7fc00000)", "8388608.0f"),
    };
    let text = CSelfTest {
        prefix,
        block: program.block,
        real: real_name(program.real),
        bits_type,
        turn,
        expected: &test.expected.iter().map(word).collect::<Vec<_>>(),
        switches: &test.switches.iter().map(switch).collect::<Vec<_>>(),
        noisy: &test.bad.iter().map(noisy).collect::<Vec<_>>(),
        not_a_number,
        middle,
        scales: test.scales.map(LANGUAGE.literal),
        loud_from: test.loud_from,
        watched: &[
            watched("outputs", &program.outputs, &names.outputs),
            watched("state", &program.state, &names.state),
        ]
        .concat(),
    };
    text.render().expect("c: the self-test's template is filled")
}
