//! The two files of an axis in C: what goes into the templates.

use super::print::{Printer, member};
use super::types;
use crate::axis::Axis;
use crate::block::Block;
use crate::digest::digest;
use crate::program::{Expr, Origin, Program, Type, Var, Variable};
use crate::render::{CBlock, CFile, CHeader, CSelfTest, CSource, ConstantText, Group, Member, Noisy, Switch};
use crate::target::{File, comment};
use askama::Template;
use portable::{Intrinsic, Literal, RealKind};

/// Characters in a line of a comment, without the marks around it.
const COMMENT_WIDTH: usize = 110;

/// The header and the source of an axis.
///
/// # Panics
/// If a template cannot be filled, which no input can bring about.
#[must_use]
pub fn files(axis: &Axis, blocks: &[Block]) -> Vec<File> {
    let stem = format!("axis_{}", axis.name.to_ascii_lowercase());
    let (header, source) = (format!("{stem}.h"), format!("{stem}.c"));
    let texts: Vec<CBlock> = blocks.iter().map(|block| block_text(&stem, block)).collect();
    let guard = format!("{}_H", stem.to_ascii_uppercase());
    let header_body = CHeader { guard: &guard, blocks: &texts }.render().expect("c: the header's template is filled");
    let (zero, builtin_magnitude) = match axis.real {
        RealKind::F64 => ("0.0", "__builtin_fabs"),
        RealKind::F32 => ("0.0f", "__builtin_fabsf"),
    };
    let real = types::name(Type::Real, axis.real);
    let uses_magnitude = blocks.iter().any(|block| compares_magnitudes(&block.program));
    let source_body = CSource { header: &header, uses_magnitude, real, zero, builtin_magnitude, blocks: &texts };
    let source_body = source_body.render().expect("c: the source's template is filled");
    vec![with_origin(axis, header, &header_body), with_origin(axis, source, &source_body)]
}

/// Whether a program asks for a magnitude.
fn compares_magnitudes(program: &Program) -> bool {
    let mut found = false;
    for statement in program.init.iter().chain(&program.step) {
        statement.expressions(&mut |expr| {
            expr.parts(&mut |part| {
                found |= matches!(part, Expr::Intrinsic(Intrinsic::Usable | Intrinsic::Within, _));
            });
        });
    }
    found
}

/// Puts the comment that names the origin on top.
fn with_origin(axis: &Axis, file: String, body: &str) -> File {
    let text = CFile {
        file: &file,
        version: env!("CARGO_PKG_VERSION"),
        axis: &axis.name,
        real: types::name(Type::Real, axis.real),
        cycle_time_ns: axis.cycle_time_ns,
        parameters_digest: &digest(axis.canonical.as_bytes()),
        body_digest: &digest(body.as_bytes()),
        body,
    };
    let text = text.render().expect("c: the file's template is filled") + "\n";
    File { name: file, text }
}

fn block_text(stem: &str, block: &Block) -> CBlock {
    let program = &block.program;
    let prefix = format!("{stem}_{}", program.block);
    let printer = Printer::new(program);
    CBlock {
        inputs: inputs(program),
        outputs: members(&program.outputs, program.real),
        state: members(&program.state, program.real),
        constants: groups(block, &printer),
        init: printer.body(&program.init),
        step: printer.body(&program.step),
        samples: block.self_test.expected.len(),
        self_test: self_test(&prefix, block),
        prefix,
    }
}

/// The inputs; those that this axis does not need say so.
fn inputs(program: &Program) -> Vec<Member> {
    let mut members = members(&program.inputs, program.real);
    let mut read = vec![false; members.len()];
    for statement in &program.step {
        statement.expressions(&mut |expr| {
            expr.variables(&mut |var| {
                if let Var::Input(index) = var {
                    read[index] = true;
                }
            });
        });
    }
    for (member, _) in members.iter_mut().zip(read).filter(|(_, read)| !read) {
        member.doc.push_str("; not read for this axis");
    }
    members
}

fn members(variables: &[Variable], real: RealKind) -> Vec<Member> {
    let text = |variable: &Variable| Member {
        ty: types::name(variable.ty, real),
        name: member(&variable.path),
        doc: variable.doc.to_owned(),
        start: types::literal(variable.start),
    };
    variables.iter().map(text).collect()
}

/// The constants in their order, a new group where another note begins.
fn groups(block: &Block, printer: &Printer<'_>) -> Vec<Group> {
    let program = &block.program;
    let mut groups: Vec<Group> = Vec::new();
    let mut said = Vec::new();
    for (constant, name) in program.constants.iter().zip(printer.constants()) {
        let notes: Vec<&str> = match constant.origin {
            Origin::Coefficient(_) => {
                notes_of(&constant.path).filter_map(|path| block.notes.get(path)).map(String::as_str).collect()
            }
            Origin::Function => vec!["the same for every axis"],
        };
        let fresh: Vec<&str> = notes.iter().copied().filter(|note| !said.contains(note)).collect();
        let text = ConstantText {
            ty: constant_type(constant.value, program.real),
            name: name.clone(),
            value: types::literal(constant.value),
            doc: constant.doc.to_owned(),
        };
        match groups.last_mut() {
            Some(last) if fresh.is_empty() => last.constants.push(text),
            _ => groups.push(Group { note: block_comment(&fresh), constants: vec![text] }),
        }
        said.extend(notes);
    }
    groups
}

/// Notes as the inside of one comment.
fn block_comment(notes: &[&str]) -> String {
    let lines = notes.iter().flat_map(|note| comment::lines(&comment::harmless(note), COMMENT_WIDTH));
    lines.collect::<Vec<_>>().join("\n * ")
}

/// A path and those that contain it, outermost first.
fn notes_of(path: &str) -> impl Iterator<Item = &str> {
    let ends = path.char_indices().filter(|(_, character)| *character == '.').map(|(end, _)| end);
    ends.chain([path.len()]).map(|end| &path[..end])
}

fn constant_type(value: Literal, real: RealKind) -> &'static str {
    match value {
        Literal::Bool(_) => types::name(Type::Bool, real),
        Literal::U32(_) => types::name(Type::U32, real),
        Literal::F64(_) | Literal::F32(_) => types::name(Type::Real, real),
        _ => types::name(Type::I32, real),
    }
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
