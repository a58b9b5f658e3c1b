//! The common parts of the self-test and the runner of a block in C: the noise on its inputs, and the digest of its outputs
//! and state.

use crate::exercise::Noise;
use crate::target::outline::COMMENT_WIDTH;
use crate::target::{TargetBlock, bits};
use askama::Template;
use compiler::legalise::RealInput;
use compiler::print::{Printer, c::LANGUAGE, signals};
use compiler::program::{Program, Type, Variable};
use portable::RealKind;

/// The functions of the noise and of the digest, and their calls.
#[derive(Template)]
#[template(path = "c/exercise.c")]
pub(super) struct CExercise<'a> {
    /// the beginning of the functions' names
    pub(super) owner: String,
    /// whether integers are drawn in addition to those for the real inputs
    pub(super) draws: bool,
    pub(super) real: &'a str,
    pub(super) bits: usize,
    /// the suffix of numbers of this real type
    pub(super) suffix: &'a str,
    /// the factors of the noise: little, full
    pub(super) scales: [String; 2],
    /// the inputs that get noise, each with the expression that draws it
    pub(super) reals: Vec<(&'a str, String)>,
    /// whether the noise of one of them is scaled, because it is not a fraction from 0 to 1
    pub(super) is_scaled: bool,
    /// the other inputs with their usual values
    pub(super) usual: Vec<(&'a str, String)>,
    /// the input that counts the calls
    pub(super) counter: Option<&'a str>,
    /// the statements that add each output, and each part of the state, to the digest
    pub(super) folded: Vec<String>,
    /// the digests, several per line
    pub(super) expected: String,
}

impl CExercise<'_> {
    /// Whether a real is added to the digest.
    fn folds_reals(&self) -> bool {
        self.folded.iter().any(|call| call.contains("_fold_real("))
    }
}

/// The exercise in C; `owner` begins the names of its functions, `random` is the source of its integers.
pub(super) fn of<'p>(
    block: &TargetBlock<'_>,
    printer: &'p Printer<'_>,
    (owner, random): (&str, &str),
    expected: &[u32],
) -> CExercise<'p> {
    let (program, exercise) = (&*block.program, &*block.block.exercise);
    let (real, part) = (LANGUAGE.ty(Type::Real, program.real), (LANGUAGE.literal)(exercise.part));
    let noise = |of: &RealInput| match of.is_fraction {
        true => format!("({real}){owner}_integer({random}) * {part}"),
        false => format!("{owner}_noise({random}, scale)"),
    };
    let names = printer.names();
    let [_, outputs] = signals(program, &LANGUAGE);
    let outputs = folded(owner, program, "outputs", &program.outputs, &outputs);
    let state = folded(owner, program, "state", &program.state, &names.state);
    let name = |position| block.input(&names.inputs, position);
    let [quiet, loud, _] = exercise.scales.map(LANGUAGE.literal);
    CExercise {
        draws: false,
        real,
        bits: bits(program.real),
        suffix: suffix(program.real),
        scales: [quiet, loud],
        reals: exercise.reals.iter().map(|real| (name(real.position), noise(real))).collect(),
        is_scaled: exercise.reals.iter().any(|real| !real.is_fraction),
        usual: block.usual(&names.inputs, LANGUAGE.literal),
        counter: exercise.counter().map(name),
        folded: [outputs, state].concat(),
        expected: in_lines(expected),
        owner: owner.to_owned(),
    }
}

/// The calls that add the variables of a struct to the digest.
fn folded(owner: &str, program: &Program, of: &str, variables: &[Variable], names: &[String]) -> Vec<String> {
    let fold = |(variable, member): (&Variable, &String)| {
        let cast = match variable.ty {
            Type::Real if program.is_single(variable) => "_real(digest, (double)",
            Type::Real => "_real(digest, ",
            Type::I32 => "(digest, (uint32_t)",
            Type::Bool | Type::U32 => "(digest, ",
        };
        [owner, "_fold", cast, of, ".", member, ")"].concat()
    };
    variables.iter().zip(names).map(fold).collect()
}

/// The suffix of numbers of a real type.
pub(super) fn suffix(real: RealKind) -> &'static str {
    match real {
        RealKind::F64 => "",
        RealKind::F32 => "f",
    }
}

/// Words in lines of limited length.
fn in_lines(words: &[u32]) -> String {
    let words: Vec<String> = words.iter().map(|word| format!("UINT32_C(0x{word:08x})")).collect();
    let in_line = COMMENT_WIDTH / ("UINT32_C(0x00000000), ".len());
    let lines: Vec<String> = words.chunks(in_line).map(|line| line.join(", ")).collect();
    lines.join(",\n    ")
}
