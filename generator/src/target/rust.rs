//! The file of a block in Rust: a module of any crate, without the standard library.

use super::outline::Member;
use super::structs::{Structs, Words};
use super::{File, Header, Legal, block_name, rendered};
use askama::Template;
use compiler::interp::Machine;
use compiler::print::rust::LANGUAGE;
use compiler::program::{Expr, Program, Statement, Type, Var};
use portable::RealKind;

#[derive(Template)]
#[template(path = "rust/file.rs")]
struct RustFile<'a> {
    file: &'a str,
    axis: &'a Header,
    block_name: &'static str,
    real: &'a str,
    bits: usize,
    block: &'a Structs<'a>,
    /// each struct with what its start is, and its members
    starts: [(&'a str, &'a str, &'a [Member]); 3],
}

const WORDS: Words = Words {
    language: &LANGUAGE,
    next_line: "\n// ",
    digest: |digest, real| match real {
        RealKind::F64 => format!("0x{digest:016x}"),
        RealKind::F32 => format!("0x{digest:08x}"),
    },
    bits: |value, ty, real| match (ty, real) {
        (Type::Real, _) => format!("{value}.to_bits()"),
        (Type::I32, RealKind::F64) => format!("u64::from({value} as u32)"),
        (Type::I32, RealKind::F32) => format!("{value} as u32"),
        (Type::U32, RealKind::F32) => value.to_owned(),
        (Type::Bool | Type::U32, RealKind::F64) => format!("u64::from({value})"),
        (Type::Bool, RealKind::F32) => format!("u32::from({value})"),
    },
};

/// The module of a block.
pub(super) fn files(axis: &Header, block: &Legal<'_>) -> Vec<File> {
    let mut text = Structs::of(axis, block, &WORDS);
    let starts = starts(&block.program, &text.constant_names);
    for (member, start) in text.state.iter_mut().zip(starts) {
        member.value = start;
    }
    let file = format!("{}.rs", block_name(&axis.name, block.program.block));
    let bits = match axis.real {
        RealKind::F64 => 64,
        RealKind::F32 => 32,
    };
    let real = LANGUAGE.ty(Type::Real, axis.real);
    let starts = [
        ("Inputs", "Every input with the value that it has until the caller writes it.", &*text.inputs),
        ("Outputs", "The outputs before the first cycle.", &*text.outputs),
        ("State", "The state before the first cycle.", &*text.state),
    ];
    let template = RustFile { file: &file, axis, block_name: block.program.block, real, bits, block: &text, starts };
    vec![rendered(&file, "", &template)]
}

/// What each part of the state is before the first cycle: the constant that `init` gives it, by its name, else its value.
fn starts(program: &Program, names: &[String]) -> Vec<String> {
    let machine = Machine::start(program);
    let value = |(state, value): (usize, &portable::Literal)| {
        let given = program.init.iter().rev().find(|statement| statement.mentions(Var::State(state)));
        match given {
            Some(Statement::Assign { value: Expr::Var(Var::Constant(constant)), .. }) => names[*constant].clone(),
            _ => (LANGUAGE.literal)(*value),
        }
    };
    machine.state().iter().enumerate().map(value).collect()
}
