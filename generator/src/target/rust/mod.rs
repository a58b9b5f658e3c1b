//! The file of a block in Rust: a module of any crate, without the standard library.

pub(super) mod library;
mod public;

use super::outline::{COMMENT_WIDTH, Group, Member, Outline};
use super::{BlockIdentity, File, TargetBlock, bits, block_name, rendered};
use crate::blocks::IPC;
use crate::exercise::{Exercise, Noise, SelfTest};
use askama::Template;
use compiler::interp::Machine;
use compiler::legalise::nearly_half;
use compiler::print::rust::LANGUAGE;
use compiler::print::{Appearance, Printer, comment, signals};
use compiler::program::{Expr, Program, Statement, Type, Var, Variable};
use portable::{Intrinsic, Literal, RealKind};
use public::Enum;

/// A block is a module; its self-test a function of it.
pub(super) fn called(axis: &str, block: &str, _: bool) -> [String; 2] {
    let module = block_name(axis, block);
    let test = format!("{module}::self_test");
    [module, test]
}

#[derive(Template)]
#[template(path = "rust/file.rs")]
struct RustFile<'a> {
    /// the name of the module
    module: &'a str,
    axis: &'a BlockIdentity,
    block: &'static str,
    real: &'a str,
    inputs: &'a [Member],
    /// the parameter set, if it takes one
    set: Vec<Member>,
    /// its type, if another block declares it
    shared_set: Option<String>,
    outputs: Vec<Member>,
    state: Vec<Member>,
    /// numbers that the caller can check, without those that are in `constants`
    figures: Vec<Member>,
    /// the names of the figures
    public: Vec<String>,
    enums: Vec<Enum>,
    constants: Vec<Group>,
    /// the rare part, as a separate function; empty if `step` is one function
    any_cycle: String,
    step: String,
    /// what it is for, and what its first call does
    purpose: String,
    /// when its caller calls it
    rate: &'static str,
    /// its proven range, and its measured response
    certificate: String,
    uses_nearest: bool,
    nearly_half: String,
    self_test: RustSelfTest<'a>,
}

/// The function `self_test`.
#[derive(Template)]
#[template(path = "rust/self_test.rs")]
struct RustSelfTest<'a> {
    real: &'a str,
    bits: usize,
    inputs: &'a [Member],
    exercise: &'a Exercise,
    self_test: &'a SelfTest,
    /// the inputs that are set once
    usual: Vec<(&'a str, String)>,
    /// the input that counts the calls
    counter: Option<&'a str>,
    scales: [String; 3],
    /// the factor of noise for a fraction from 0 to 1
    part: String,
    /// the words of every output, and of every part of the state
    watched: Vec<[String; 2]>,
}

impl RustSelfTest<'_> {
    /// Whether an input gets noise that is scaled.
    fn is_scaled(&self) -> bool {
        self.exercise.reals.iter().any(|real| !real.is_fraction)
    }
}

impl RustFile<'_> {
    /// Each struct with the source of its start values, and its members.
    fn starts(&self) -> Vec<(&str, &str, &[Member])> {
        let set = ("Params", "The set that the block was generated with.", self.set.as_slice());
        let always: [(_, _, &[Member]); 3] = [
            ("Inputs", "Every input with the value that it has until the caller writes it.", self.inputs),
            ("Outputs", "The outputs before the first cycle.", &self.outputs),
            ("State", "The state before the first cycle.", &self.state),
        ];
        (!self.set.is_empty() && self.shared_set.is_none()).then_some(set).into_iter().chain(always).collect()
    }
}

/// The module of a block.
pub(super) fn files(axis: &BlockIdentity, block: &TargetBlock<'_>) -> Vec<File> {
    let program = &*block.program;
    let printer = &Printer::new(program, &LANGUAGE, "");
    let outline = &Outline { axis, block, language: &LANGUAGE, printer, next_line: "\n// " };
    let module = &block_name(&axis.name, program.block);
    let set = outline.set();
    let inputs = &inputs(outline, !set.is_empty());
    let [constants] = outline.groups([Appearance::Declared]);
    let figures = public::figures(axis, block);
    let public = figures.iter().map(|figure| figure.name.clone()).collect();
    let is_constant = |name: &str| constants.iter().any(|group| group.constants.iter().any(|of| of.name == name));
    let of_ipc = |item: &str| format!("super::{}::{item}", block_name(&axis.name, IPC));
    let template = RustFile {
        module,
        axis,
        block: program.block,
        real: LANGUAGE.ty(Type::Real, axis.real),
        inputs,
        shared_set: (block.block.shares_set() && !set.is_empty()).then(|| of_ipc("Params")),
        set,
        outputs: outline.outputs(["Params", "Params::new()"].map(of_ipc)),
        state: state(outline),
        figures: figures.into_iter().filter(|figure| !is_constant(&figure.name)).collect(),
        public,
        enums: public::enums(outline),
        constants,
        any_cycle: printer.body(program.apart(), 1),
        step: printer.body(&program.step, 1),
        rate: block.rate(),
        purpose: comment::wrapped(&[&block.block.purpose], COMMENT_WIDTH, "\n//! "),
        certificate: comment::wrapped(&block.block.certificate.lines, COMMENT_WIDTH, "\n//! "),
        uses_nearest: program.asks_for(&[Intrinsic::Nearest]),
        nearly_half: (LANGUAGE.literal)(nearly_half(axis.real)),
        self_test: self_test(outline, inputs),
    };
    vec![rendered(&format!("{module}.rs"), "", &template)]
}

/// The members of the inputs, the parameter set after the signals.
fn inputs(outline: &Outline<'_>, has_set: bool) -> Vec<Member> {
    let set = has_set.then(|| Member {
        ty: "Params".into(),
        name: "params".to_owned(),
        doc: "the parameter set".to_owned(),
        value: "Params::new()".to_owned(),
    });
    outline.inputs().into_iter().chain(set).collect()
}

/// The members of the state, with their start values.
fn state(outline: &Outline<'_>) -> Vec<Member> {
    let starts = starts(&outline.block.program, &outline.printer.names().constants);
    let parts = outline.parts_of_state().into_iter().zip(starts);
    let parts = parts.map(|(member, value)| Member { value, ..member }).collect();
    outline.state(parts, |of, length| Member {
        ty: format!("[{}; {length}]", of.ty).into(),
        value: format!("[{}; {length}]", of.value),
        ..of
    })
}

fn self_test<'t>(outline: &Outline<'t>, inputs: &'t [Member]) -> RustSelfTest<'t> {
    let (block, names) = (outline.block, outline.printer.names());
    let (program, exercise) = (&*block.program, &*block.block.exercise);
    let outputs = watched(program, "outputs", &program.outputs, &signals(program, &LANGUAGE)[1]);
    let state = watched(program, "state", &program.state, &names.state);
    RustSelfTest {
        real: LANGUAGE.ty(Type::Real, outline.axis.real),
        bits: bits(outline.axis.real),
        inputs,
        exercise,
        self_test: &block.block.self_test,
        usual: block.usual(&names.inputs, LANGUAGE.literal),
        counter: exercise.counter().map(|at| block.input(&names.inputs, at)),
        scales: exercise.scales.map(LANGUAGE.literal),
        part: (LANGUAGE.literal)(exercise.part),
        watched: [outputs, state].concat(),
    }
}

/// The words of all variables of a struct for the digest.
fn watched(program: &Program, of: &str, variables: &[Variable], names: &[String]) -> Vec<[String; 2]> {
    let words = |(variable, name): (&Variable, &String)| {
        let value = format!("{of}.{name}");
        let value = if program.is_single(variable) { format!("f64::from({value})") } else { value };
        words(&value, variable.ty, program.real)
    };
    variables.iter().zip(names).map(words).collect()
}

/// The words of a value for the digest; the second one may be empty.
fn words(value: &str, ty: Type, real: RealKind) -> [String; 2] {
    match (ty, real) {
        (Type::Real, RealKind::F64) => {
            [format!("{value}.to_bits() as u32"), format!("({value}.to_bits() >> 32) as u32")]
        }
        (Type::Real, RealKind::F32) => [format!("{value}.to_bits()"), String::new()],
        (Type::I32, _) => [format!("{value} as u32"), String::new()],
        (Type::U32, _) => [value.to_owned(), String::new()],
        (Type::Bool, _) => [format!("u32::from({value})"), String::new()],
    }
}

/// Each part of the state before the first cycle: the constant that `init` assigns, by its name, else its value.
fn starts(program: &Program, names: &[String]) -> Vec<String> {
    let machine = Machine::start(program);
    let value = |(state, value): (usize, &Literal)| {
        let given = program.init.iter().rev().find(|statement| statement.mentions(Var::State(state)));
        match given {
            Some(Statement::Assign { value: Expr::Var(Var::Constant(constant)), .. }) => names[*constant].clone(),
            _ => (LANGUAGE.literal)(*value),
        }
    };
    machine.state().iter().enumerate().map(value).collect()
}
