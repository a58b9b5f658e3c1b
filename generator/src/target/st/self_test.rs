//! The self-test of a block: a function block that calls it, one sample per cycle, and compares its outputs with those of
//! the reference.

use super::dialect::Dialect;
use super::listing::{self, Listing, SET};
use crate::exercise::{Answer, Noise, Trial, Turn};
use crate::target::outline::Member;
use crate::target::{BlockIdentity, TargetBlock};
use askama::Template;
use compiler::legalise::{Cycle, RealInput};
use compiler::print::{signals, st};
use compiler::program::{Type, Variable};
use portable::{Literal, Real, RealKind};
use std::borrow::Cow;
use std::ops::Range;

/// The signal that turns a block on.
const ENABLE: &str = "Enable";

/// Its outputs, with their meanings.
pub(super) const OUTPUTS: [(&str, &str); 2] = [
    ("done", "all samples have run"),
    ("differing", "number of values so far that differ from the reference: 0 in a correct build"),
];

/// Its real variables, with their meanings.
const REALS: [(&str, &str); 7] = [
    ("noise", "pseudo-random integer of 22 bits, minus half of its range"),
    ("noise_scale", "factor of the noise"),
    ("small", "additional factor of small samples"),
    ("factor", "number whose square must be rounded"),
    ("square", "rounded square of factor"),
    ("remainder", "factor * factor - square: not 0 if the build fuses operations"),
    ("nothing", "0, the value that remainder must have"),
];

/// The name of the self-test of a function block.
pub(super) fn name(tested: &str) -> String {
    format!("{tested}_self_test")
}

/// The statements.
#[derive(Template)]
#[template(path = "st/self_test.st")]
struct Body<'a> {
    /// the mark before a variable
    mark: &'a str,
    trial: &'a Trial,
    real: &'a str,
    is_single: bool,
    scales: [String; 3],
    small: String,
    /// names of the inputs that get noise; for a fraction from 0 to 1 also its first value
    noise: Vec<(&'a str, Option<String>)>,
    has_parts: bool,
    /// the factor of noise for such a fraction
    part: String,
    /// the inputs that are turned
    switches: Vec<Switch<'a>>,
    /// the samples in which an input is out of range or huge, and its value
    jumps: Vec<(&'a Range<usize>, &'a str, String)>,
    /// a number and its square, rounded
    contraction: [String; 2],
    inputs: Vec<&'a str>,
    /// the parameter set, part by part: some compilers ignore the start values of a structure
    set: Vec<(&'a str, String)>,
    outputs: &'a [String],
    /// the expected outputs from a sample on: names and values
    steps: Vec<Step<'a>>,
}

/// The expected outputs from a sample on, with their values.
type Step<'a> = (usize, Vec<(&'a str, Cow<'a, str>)>);

/// An input with different values at some times, otherwise its usual one.
struct Switch<'a> {
    name: &'a str,
    /// its last value if it continues to count from there; else empty
    before: String,
    usual: String,
    turns: Vec<(&'a Turn, String)>,
}

/// The self-test as a function block.
pub(super) fn listing(axis: &BlockIdentity, block: &TargetBlock<'_>, dialect: &Dialect) -> Listing {
    let signals = &signals(&block.program, dialect.language);
    let tested = listing::name(&axis.name, block.program.block, dialect);
    let types = [Type::Bool, Type::I32].map(|ty| dialect.language.ty(ty, axis.real));
    Listing {
        name: name(&tested),
        quote: dialect.quote,
        set: None,
        inputs: Vec::new(),
        outputs: types.into_iter().zip(OUTPUTS).map(|(ty, (name, doc))| member(ty, name, doc)).collect(),
        state: state(axis, block, dialect, &tested, signals),
        locals: Vec::new(),
        inline: Vec::new(),
        declared: Vec::new(),
        assigned: Vec::new(),
        body: body(block, dialect, signals),
    }
}

fn state(
    axis: &BlockIdentity,
    block: &TargetBlock<'_>,
    dialect: &Dialect,
    tested: &str,
    [inputs, outputs]: &[Vec<String>; 2],
) -> Vec<Member> {
    let program = &*block.program;
    let ty = |ty: Type| dialect.language.ty(ty, axis.real);
    let is_signal = |(input, _): &(&Variable, &String)| program.in_set(input).is_none();
    let of_inputs = program.inputs.iter().zip(inputs).filter(is_signal);
    let of_outputs = program.outputs.iter().zip(outputs).filter(|(output, _)| program.in_made(output).is_none());
    let mut state = vec![
        member(format!("{0}{tested}{0}", dialect.quote), "block", "the block under test"),
        member(ty(Type::I32), "sample", "number of the sample"),
        member(ty(Type::I32), "random", "state of the pseudo-random generator"),
    ];
    let product = ("product", "factor * factor, rounded by this controller");
    let part = ("part", "factor of noise in the range 0 to 1");
    let reals = (axis.real == RealKind::F32).then_some(product).into_iter();
    let reals = reals.chain(block.block.trial.has_parts().then_some(part)).chain(REALS);
    state.extend(reals.map(|(name, doc)| member(ty(Type::Real), name, doc)));
    let given = "input of the block under test";
    state.extend(of_inputs.map(|(input, name)| member(ty(input.ty), format!("in_{name}"), given)));
    let expected = "output of the reference";
    state.extend(of_outputs.map(|(output, name)| member(ty(output.ty), format!("expected_{name}"), expected)));
    let set = || listing::made(axis, dialect);
    let made = |made| member(set(), format!("expected_{made}"), "parameter set of the reference");
    state.extend(program.made.map(made));
    state.extend(program.has_set().then(|| member(set(), SET, "the parameter set")));
    state
}

fn member(ty: impl Into<Cow<'static, str>>, name: impl Into<String>, doc: &str) -> Member {
    Member { ty: ty.into(), name: name.into(), doc: doc.to_owned(), value: String::new() }
}

fn body(block: &TargetBlock<'_>, dialect: &Dialect, [inputs, outputs]: &[Vec<String>; 2]) -> String {
    let (program, trial, literal) = (&block.program, &block.block.trial, dialect.language.literal);
    let is_single = program.real == RealKind::F32;
    let real = |value: f64| if is_single { Literal::F32(f32::lit(value)) } else { Literal::F64(value) };
    let name_of = |position: usize| {
        let path = &block.block.program.inputs[position].path;
        let own = program.inputs.iter().position(|input| input.path == *path);
        own.map_or("", |own| inputs[own].as_str())
    };
    let is_jump = |turn: &&Turn| trial.exercise.reals.iter().any(|real| real.position == turn.input);
    let jumps = trial.turns.iter().filter(is_jump);
    let named = program.inputs.iter().zip(inputs);
    let (parts, signals): (Vec<_>, Vec<_>) = named.partition(|(input, _)| program.in_set(input).is_some());
    let switches = signals.iter().filter(|(input, _)| input.ty != Type::Real || program.typed);
    let factor = if is_single { 1.0 + libm::exp2(-15.0) } else { 1.0 + libm::exp2(-30.0) };
    let square = if is_single { 1.0 + libm::exp2(-14.0) } else { factor * factor };
    let noise = |of: &RealInput| {
        let usual = of.is_fraction.then(|| literal(trial.exercise.usual[of.position]));
        (name_of(of.position), usual)
    };
    let body = Body {
        mark: dialect.mark,
        trial,
        real: dialect.language.ty(Type::Real, program.real),
        is_single,
        scales: trial.exercise.scales.map(literal),
        small: literal(real(Noise::SMALL.into())),
        noise: trial.exercise.reals.iter().map(noise).collect(),
        has_parts: trial.has_parts(),
        part: literal(trial.exercise.part),
        switches: switches.map(|(input, name)| switch(block, dialect, input, name)).collect(),
        jumps: jumps.map(|turn| (&turn.samples, name_of(turn.input), literal(turn.value))).collect(),
        contraction: [factor, square].map(|value| literal(real(value))),
        inputs: signals.iter().map(|(_, name)| name.as_str()).collect(),
        set: parts.iter().map(|(part, name)| (name.as_str(), literal(part.start))).collect(),
        outputs,
        steps: steps(block, outputs),
    };
    body.render().expect("target: no input can keep a template from being filled") + "\n"
}

/// An input that is turned. If the block has the signal Enable, this signal turns the block off.
fn switch<'n>(block: &TargetBlock<'n>, dialect: &Dialect, input: &Variable, name: &'n str) -> Switch<'n> {
    let (trial, literal) = (&block.block.trial, dialect.language.literal);
    let Some(position) = block.block.program.inputs.iter().position(|known| known.path == input.path) else {
        let off = trial.turns.iter().filter(|turn| turn.is_off);
        let turns = off.map(|turn| (turn, literal(Literal::Bool(false)))).collect();
        return Switch { name, before: String::new(), usual: literal(Literal::Bool(true)), turns };
    };
    let has_enable = block.program.inputs[0].path == ENABLE;
    let turns = trial.turns_of(position).filter(|turn| !(turn.is_off && has_enable));
    let counts = trial.exercise.counter() == Some(position);
    Switch {
        name,
        before: if counts { format!("{}in_{name} + ", dialect.mark) } else { String::new() },
        usual: literal(trial.exercise.usual[position]),
        turns: turns.map(|turn| (turn, literal(turn.value))).collect(),
    }
}

/// What is expected, where it changes: signals that a legalising pass has added, which come first, and the block's outputs.
fn steps<'n>(block: &'n TargetBlock<'_>, names: &'n [String]) -> Vec<Step<'n>> {
    let (all, outputs) = (&block.block.program.outputs, &block.program.outputs);
    let place = |path: &str| all.iter().position(|known| known.path == path);
    let [fault, error_id] = ["fault", "error_id"].map(place);
    let name = |known: &Variable| Some(&names[outputs.iter().position(|output| output.path == known.path)?]);
    let own: Vec<Option<&String>> = all.iter().map(name).collect();
    let named = outputs.iter().zip(names);
    let added: Vec<_> = named.filter(|(output, _)| place(&output.path).is_none()).collect();
    let cycle = |answer: &Answer| Cycle {
        fault: fault.is_some_and(|at| answer.outputs[at] == Literal::Bool(true)),
        error_id: if let Some(Literal::U32(id)) = error_id.map(|at| answer.outputs[at]) { id } else { 0 },
        is_enabled: !answer.is_off,
        works: answer.is_busy,
    };
    let (mut before, mut steps) = (None, Vec::new());
    for answer in block.block.answers.iter() {
        let now = Some(cycle(answer));
        let changed = |(output, name): &(&Variable, &'n String)| {
            let [before, value] = [before, now].map(|cycle: Option<Cycle>| cycle?.value(&output.path));
            value.filter(|_| before != value).map(|value| (name.as_str(), Cow::Owned(st::literal(value))))
        };
        let mut step: Vec<_> = if before == now { Vec::new() } else { added.iter().filter_map(changed).collect() };
        let own = answer.changes.iter().filter_map(|(at, text)| Some((own[*at]?.as_str(), Cow::Borrowed(&**text))));
        step.extend(own);
        if !step.is_empty() {
            steps.push((answer.sample, step));
        }
        before = now;
    }
    steps
}
