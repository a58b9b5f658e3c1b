//! The two files of a block in C.

use super::structs::{Structs, Words};
use super::{File, Header, Legal, block_name, rendered};
use askama::Template;
use compiler::print::c::LANGUAGE;
use compiler::program::Type;
use portable::RealKind;

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
    prefix: &'a str,
    block: &'a Structs<'a>,
}

#[derive(Template)]
#[template(path = "c/source_body.c")]
struct CSource<'a> {
    header: &'a str,
    real: &'a str,
    bits: usize,
    /// what the numbers of this real type and the compilers' own functions for it end with
    suffix: &'a str,
    /// what the names that its caller sees begin with
    prefix: &'a str,
    block: &'a Structs<'a>,
}

const WORDS: Words = Words {
    language: &LANGUAGE,
    next_line: "\n * ",
    digest: |digest, real| match real {
        RealKind::F64 => format!("UINT64_C(0x{digest:016x})"),
        RealKind::F32 => format!("UINT32_C(0x{digest:08x})"),
    },
    bits: |value, ty, _| match ty {
        Type::Real => format!("bits_of({value})"),
        Type::I32 => format!("(uint32_t){value}"),
        Type::Bool | Type::U32 => value.to_owned(),
    },
};

/// The header and the source of a block.
pub(super) fn files(axis: &Header, block: &Legal<'_>) -> Vec<File> {
    let prefix = &block_name(&axis.name, block.program.block);
    let (header, source) = (format!("{prefix}.h"), format!("{prefix}.c"));
    let (bits, suffix) = match axis.real {
        RealKind::F64 => (64, ""),
        RealKind::F32 => (32, "f"),
    };
    let real = LANGUAGE.ty(Type::Real, axis.real);
    let guard = format!("{}_H", prefix.to_ascii_uppercase());
    let text = &Structs::of(axis, block, &WORDS);
    let source_body = CSource { header: &header, real, bits, suffix, prefix, block: text };
    let header_body = CHeader { guard, prefix, block: text };
    let block = block.program.block;
    vec![
        rendered(&header, "", &CFile { file: &header, axis, block, real, body: header_body }),
        rendered(&source, "", &CFile { file: &source, axis, block, real, body: source_body }),
    ]
}
