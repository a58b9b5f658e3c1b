//! The block `ipc` of an axis as the model sees it: inputs, outputs and parameter sets by name. The only file here that knows how the
//! generator makes a block.

use super::history::Given;
use super::set::{Set, Structure};
use generator::blocks::{self, Designed};
use portable::{Block as Reference, Literal, Portable, Real, RealKind, Ty};
use reference::ipc::Ipc;
use reference::tunable_ipc::{self, TunableIpc};

/// The scalars of a type by their paths, in the order in which it is visited, and 0 of the type of each.
fn scalars<T: Portable>() -> Vec<(String, Literal)> {
    let mut found = Vec::new();
    add(&T::TY, "", &mut found);
    found
}

fn add(ty: &Ty, path: &str, found: &mut Vec<(String, Literal)>) {
    let zero = match ty {
        Ty::Struct { def } => {
            let dot = if path.is_empty() { "" } else { "." };
            def.fields.iter().for_each(|field| add(&field.ty, &format!("{path}{dot}{}", field.name), found));
            return;
        }
        Ty::Array { element, len } => {
            (0..*len).for_each(|i| add(element, &format!("{path}[{i}]"), found));
            return;
        }
        Ty::Bool => Literal::Bool(false),
        Ty::I32 => Literal::I32(0),
        Ty::U32 => Literal::U32(0),
        Ty::Real(kind) => real(0.0, *kind),
        other => panic!("model: an input of the type {other:?}"),
    };
    found.push((path.to_owned(), zero));
}

fn real(value: f64, kind: RealKind) -> Literal {
    match kind {
        RealKind::F64 => Literal::F64(value),
        RealKind::F32 => Literal::F32(f32::lit(value)),
    }
}

fn number(literal: Literal) -> f64 {
    match literal {
        Literal::F64(value) => value,
        Literal::F32(value) => value.into(),
        Literal::U32(value) => value.into(),
        Literal::I32(value) => value.into(),
        Literal::Bool(value) => f64::from(u8::from(value)),
        other => panic!("model: {other:?}"),
    }
}

/// The set that the parameters of an axis make, with the numbers that its structure has.
#[must_use]
pub fn set(designed: &Designed, structure: &Structure, of: usize) -> Set {
    match designed.axis.real {
        RealKind::F64 => set_as::<f64>(designed, structure, of),
        RealKind::F32 => set_as::<f32>(designed, structure, of),
    }
}

fn set_as<R: Real>(designed: &Designed, structure: &Structure, of: usize) -> Set
where
    TunableIpc: Reference<R, Coeffs = tunable_ipc::Coeffs<R>, Inputs = tunable_ipc::Inputs<R>>,
{
    let kind = blocks::named("ipc").expect("the axis has the block");
    let mut leaves = kind.coefficients(designed).into_iter();
    let coeffs = Portable::build(&mut || leaves.next().expect("all coefficients"));
    let inputs = compiler::leaves(&<TunableIpc as Reference<R>>::inputs(&coeffs));
    let names = scalars::<tunable_ipc::Inputs<R>>();
    let value = |name: &str| {
        let name = format!("params.{name}");
        inputs[names.iter().position(|(of, _)| *of == name).unwrap_or_else(|| panic!("no `{name}`"))]
    };
    let integer = |name: &str| match value(name) {
        Literal::U32(value) => value,
        other => panic!("{name} is {other:?}"),
    };
    Set {
        structure: integer("structure"),
        set_id: integer("set_id"),
        numbers: structure.names.iter().map(|name| number(value(name))).collect(),
        of,
    }
}

/// Where an input comes from.
#[derive(Clone, Copy, Debug)]
enum Input {
    Command,
    Motor,
    Direct,
    Weight(usize),
    Limit,
    Mode,
    Controlled,
    Reset,
    Cycle,
    Structure,
    SetId,
    Number(usize),
    /// of a stage that the axis does not have
    Unused,
}

impl Input {
    fn of(name: &str, structure: &Structure) -> Self {
        let in_set = name.strip_prefix("params.");
        match in_set.unwrap_or(name) {
            "v_command" => Self::Command,
            "v_motor" => Self::Motor,
            "v_direct" => Self::Direct,
            "tuning_weight[0]" => Self::Weight(0),
            "tuning_weight[1]" => Self::Weight(1),
            "tuning_weight[2]" => Self::Weight(2),
            "tuning_limit" => Self::Limit,
            "mode" => Self::Mode,
            "position_controlled" => Self::Controlled,
            "reset" => Self::Reset,
            "task_cycle_ns" => Self::Cycle,
            "structure" => Self::Structure,
            "set_id" => Self::SetId,
            number => structure.names.iter().position(|name| name == number).map_or(Self::Unused, Self::Number),
        }
    }
}

/// One cycle of the reference: from the scalars of its inputs to those of its outputs.
type Cycle = dyn FnMut(&[Literal], &mut Vec<Literal>);

/// The block between two cycles.
pub struct Block {
    run: Box<Cycle>,
    real: RealKind,
    /// where each input comes from, and 0 of its type
    inputs: Vec<(Input, Literal)>,
    outputs: Vec<String>,
    given: Vec<Literal>,
    found: Vec<Literal>,
}

impl Block {
    /// Before the first cycle.
    ///
    /// # Panics
    /// If the axis has no block `ipc`.
    #[must_use]
    pub fn new(designed: &Designed, structure: &Structure) -> Self {
        let real = designed.axis.real;
        let [inputs, outputs] = match (designed.axis.ipc.takes_sets(), real) {
            (true, RealKind::F64) => signals::<f64, TunableIpc>(),
            (true, RealKind::F32) => signals::<f32, TunableIpc>(),
            (false, RealKind::F64) => signals::<f64, Ipc>(),
            (false, RealKind::F32) => signals::<f32, Ipc>(),
        };
        let inputs = inputs.into_iter().map(|(name, zero)| (Input::of(&name, structure), zero)).collect();
        let outputs = outputs.into_iter().map(|(name, _)| name).collect();
        let mut reference = blocks::named("ipc").expect("the axis has the block").start(designed);
        let run = Box::new(move |inputs: &[Literal], outputs: &mut Vec<Literal>| reference.step(inputs, outputs));
        Self { run, real, inputs, outputs, given: Vec::new(), found: Vec::new() }
    }

    /// One cycle.
    pub fn step(&mut self, given: &Given) {
        let Given { inputs, v_command, offered } = given;
        let real = |value: f64| real(value, self.real);
        let value = |(input, zero): &(Input, Literal)| match *input {
            Input::Command => real(*v_command),
            Input::Motor => real(inputs.v_motor),
            Input::Direct => real(inputs.v_direct),
            Input::Weight(i) => real(inputs.tuning_weight[i]),
            Input::Limit => real(inputs.tuning_limit),
            Input::Mode => Literal::I32(inputs.mode),
            Input::Controlled => Literal::Bool(inputs.position_controlled),
            Input::Reset => Literal::Bool(inputs.reset),
            Input::Cycle => Literal::U32(inputs.task_cycle_ns),
            Input::Structure => Literal::U32(offered.structure),
            Input::SetId => Literal::U32(offered.set_id),
            Input::Number(i) => real(offered.numbers[i]),
            Input::Unused => *zero,
        };
        self.given.clear();
        self.given.extend(self.inputs.iter().map(value));
        (self.run)(&self.given, &mut self.found);
    }

    /// An output of the last cycle, FALSE and TRUE as 0 and 1; 0 where the block has no such output.
    #[must_use]
    pub fn output(&self, name: &str) -> f64 {
        self.outputs.iter().position(|of| of == name).map_or(0.0, |at| number(self.found[at]))
    }

    /// All of them.
    #[must_use]
    pub fn outputs(&self) -> Vec<(&str, f64)> {
        self.outputs.iter().map(String::as_str).zip(self.found.iter().copied().map(number)).collect()
    }
}

fn signals<R: Real, B: Reference<R>>() -> [Vec<(String, Literal)>; 2] {
    [scalars::<B::Inputs>(), scalars::<B::Outputs>()]
}
