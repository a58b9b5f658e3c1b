//! A block as structs and functions: what the files of C and of Rust say of it, each in its language.

use super::outline::{COMMENT_WIDTH, Group, Member, Outline};
use super::{Header, Legal};
use crate::self_test::SelfTest;
use compiler::print::{Appearance, Language, Printer, comment};
use compiler::program::{Expr, Program, Statement, Type, Variable};
use portable::{Intrinsic, Literal, RealKind};

/// How a language says what a self-test needs.
pub(super) struct Words {
    pub(super) language: &'static Language,
    /// between two lines of a comment at the left
    pub(super) next_line: &'static str,
    /// a digest
    pub(super) digest: fn(u64, RealKind) -> String,
    /// the bits of a value, as the digest takes them
    pub(super) bits: fn(&str, Type, RealKind) -> String,
}

/// A block with its self-test.
pub(super) struct Structs<'a> {
    pub(super) inputs: Vec<Member>,
    pub(super) outputs: Vec<Member>,
    pub(super) state: Vec<Member>,
    /// the numbers that are declared one by one
    pub(super) constants: Vec<Group>,
    pub(super) enumerations: Vec<Group>,
    /// the names of all of them, in the program's order
    pub(super) constant_names: Vec<String>,
    pub(super) init: String,
    /// what seldom runs, a function of its own; empty where `step` is one function
    pub(super) any_cycle: String,
    pub(super) step: String,
    /// what is certain of its range, and its measured response
    pub(super) certificate: String,
    pub(super) self_test: &'a SelfTest,
    /// the digest after each sample
    pub(super) expected: Vec<String>,
    /// the inputs that are set once, by position
    pub(super) switches: Vec<(usize, String)>,
    pub(super) scales: [String; 2],
    /// the bits of every output, and of every part of the state that is defined from the first sample on
    pub(super) watched: Vec<String>,
    pub(super) uses_nearest: bool,
    pub(super) uses_magnitude: bool,
    pub(super) nearly_half: String,
}

impl<'a> Structs<'a> {
    pub(super) fn of(axis: &'a Header, block: &'a Legal<'_>, words: &Words) -> Self {
        let (program, self_test) = (&*block.program, &block.block.self_test);
        let Words { language, next_line, .. } = *words;
        let printer = &Printer::new(program, language);
        let outline = Outline { axis, block, language, printer, next_line };
        let names = printer.names();
        let bits = |of: &str, variable: &Variable, name: &str| {
            (words.bits)(&format!("{of}.{name}"), variable.ty, program.real)
        };
        let outputs = program.outputs.iter().zip(&names.outputs).map(|(output, name)| bits("outputs", output, name));
        let state = self_test.state.iter().map(|at| bits("state", &program.state[*at], &names.state[*at]));
        let nearly_half = match program.real {
            RealKind::F64 => Literal::F64(portable::nearly_half()),
            RealKind::F32 => Literal::F32(portable::nearly_half()),
        };
        Self {
            inputs: outline.inputs(),
            outputs: outline.outputs(),
            state: outline.state(),
            constants: outline.groups(Appearance::Declared),
            enumerations: outline.groups(Appearance::Enumerator),
            constant_names: names.constants.clone(),
            init: printer.body(&program.init, 1),
            any_cycle: printer.body(apart(&program.step), 1),
            step: printer.body(&program.step, 1),
            certificate: comment::wrapped(&block.block.certificate, COMMENT_WIDTH, next_line),
            self_test,
            expected: self_test.expected.iter().map(|digest| (words.digest)(*digest, program.real)).collect(),
            switches: self_test.switches.iter().map(|(index, value)| (*index, (language.literal)(*value))).collect(),
            scales: self_test.scales.map(language.literal),
            watched: outputs.chain(state).collect(),
            uses_nearest: asks_for(program, &[Intrinsic::Nearest]),
            uses_magnitude: asks_for(program, &[Intrinsic::InRange, Intrinsic::Within]),
            nearly_half: (language.literal)(nearly_half),
        }
    }
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
