//! The runner of a block in C: a program for a user's own board, but for how the board prints and counts.

use super::names;
use crate::noise::part;
use crate::runner::Runner;
use crate::target::outline::COMMENT_WIDTH;
use crate::target::{File, Header, Legal, rendered};
use askama::Template;
use compiler::print::{Printer, c::LANGUAGE};
use compiler::program::{Type, Variable};
use portable::{Literal, RealKind};

#[derive(Template)]
#[template(path = "c/runner.c")]
struct CRunner<'a> {
    file: &'a str,
    axis: &'a Header,
    block: &'static str,
    real: &'a str,
    bits: usize,
    /// what the numbers of this real type end with
    suffix: &'a str,
    prefix: &'a str,
    runner: &'a Runner,
    scales: [String; 2],
    beyond: String,
    usual: Vec<(&'a str, String)>,
    /// the input that counts the calls
    counter: Option<&'a str>,
    drill: Vec<(usize, usize, &'a str, String)>,
    turns: Vec<(&'a str, String)>,
    /// each with whether it is a part from 0 to 1
    reals: Vec<(&'a str, bool)>,
    /// the factor of noise that is such a part
    part: String,
    /// what takes each output, and each part of the state, into the digest
    folded: Vec<String>,
    /// the digests, some in a line
    expected: String,
}

/// The runner of a block.
pub(in crate::target) fn file(axis: &Header, block: &Legal<'_>, runner: &Runner) -> File {
    let program = &*block.program;
    let prefix = names::prefix(axis, program.block);
    let file = format!("{prefix}_runner.c");
    let printer = Printer::new(program, &LANGUAGE, &prefix);
    let names = printer.names();
    let input = |at: &usize| names.inputs[*at].as_str();
    let setting = |(at, value): &(usize, Literal)| (input(at), (LANGUAGE.literal)(*value));
    let outputs =
        program.outputs.iter().zip(&names.outputs).map(|(output, name)| fold(&prefix, "outputs", output, name));
    let state = program.state.iter().zip(&names.state).map(|(part, name)| fold(&prefix, "state", part, name));
    let drill = |(samples, at, value): &(std::ops::Range<usize>, usize, Literal)| {
        (samples.start, samples.end, input(at), (LANGUAGE.literal)(*value))
    };
    let template = CRunner {
        file: &file,
        axis,
        block: program.block,
        real: LANGUAGE.ty(Type::Real, axis.real),
        bits: if axis.real == RealKind::F64 { 64 } else { 32 },
        suffix: if axis.real == RealKind::F64 { "" } else { "f" },
        prefix: &prefix,
        runner,
        scales: runner.scales.map(LANGUAGE.literal),
        beyond: (LANGUAGE.literal)(runner.beyond),
        usual: runner.usual.iter().map(setting).collect(),
        counter: runner.counter.as_ref().map(input),
        drill: runner.drill.iter().map(drill).collect(),
        turns: runner.turns.iter().map(setting).collect(),
        reals: runner.reals.iter().map(|real| (input(&real.own), real.is_fraction)).collect(),
        part: (LANGUAGE.literal)(part(axis.real)),
        folded: outputs.chain(state).collect(),
        expected: in_lines(&runner.expected),
    };
    rendered(&file, "", &template)
}

fn fold(prefix: &str, of: &str, variable: &Variable, member: &str) -> String {
    match variable.ty {
        Type::Real => format!("{prefix}_runner_fold_real(digest, {of}.{member})"),
        Type::I32 => format!("{prefix}_runner_fold(digest, (uint32_t){of}.{member})"),
        Type::Bool | Type::U32 => format!("{prefix}_runner_fold(digest, {of}.{member})"),
    }
}

/// Words in lines that fit.
fn in_lines(words: &[u32]) -> String {
    let words: Vec<String> = words.iter().map(|word| format!("UINT32_C(0x{word:08x})")).collect();
    let in_line = COMMENT_WIDTH / (words.first().map_or(1, String::len) + 2);
    let lines: Vec<String> = words.chunks(in_line).map(|line| line.join(", ")).collect();
    lines.join(",\n    ")
}
