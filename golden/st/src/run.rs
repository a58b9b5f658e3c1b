//! An instance of a block: signals by their names, and one cycle after another.

use super::block::Block;
use super::kind::Kind;
use super::machine::Slots;
use super::mistake::Mistake;
use super::variables::{Role, Variable};
use portable::{Literal, Real, RealKind};

/// A signal: its name, in any case, and a value of its type.
pub type Signal<'n> = (&'n str, Literal);

/// A block in operation.
#[derive(Clone, Debug)]
pub struct Instance<'b> {
    block: &'b Block,
    inputs: Vec<Variable>,
    outputs: Vec<Variable>,
    slots: Memory,
}

/// The slots in the real type of the block.
#[derive(Clone, Debug)]
enum Memory {
    Double(Slots<f64>),
    Single(Slots<f32>),
    /// for a block of REAL with wide operations
    Mixed(Slots<f64>),
}

impl Block {
    /// A fresh instance. `set` gives further inputs of type BOOL a value for all cycles. Every other input keeps its start
    /// value.
    ///
    /// # Errors
    /// A name is not that of an input or output of the signal's type.
    pub fn start(
        &self,
        inputs: &[Signal<'_>],
        outputs: &[Signal<'_>],
        set: &[(&str, bool)],
    ) -> Result<Instance<'_>, Vec<Mistake>> {
        let mut mistakes = Vec::new();
        let mut all = |signals: &[Signal<'_>], role| -> Vec<Variable> {
            signals.iter().filter_map(|signal| self.signal(*signal, role, &mut mistakes)).collect()
        };
        let (inputs, outputs) = (all(inputs, Role::Input), all(outputs, Role::Output));
        let mut start = self.variables.slots.clone();
        for &(name, value) in set {
            if let Some(variable) = self.signal((name, Literal::Bool(value)), Role::Input, &mut mistakes) {
                start.bools[variable.slot as usize] = value;
            }
        }
        if !mistakes.is_empty() {
            return Err(mistakes);
        }
        let slots = match self.variables.real {
            RealKind::F64 => Memory::Double(Slots::start(&start)),
            RealKind::F32 if self.ops.iter().any(|op| op.wide) => Memory::Mixed(Slots::start(&start)),
            RealKind::F32 => Memory::Single(Slots::start(&start)),
        };
        Ok(Instance { block: self, inputs, outputs, slots })
    }

    fn signal(&self, (name, value): Signal<'_>, role: Role, mistakes: &mut Vec<Mistake>) -> Option<Variable> {
        let (kind, ty) = match value {
            Literal::Bool(_) => (Some(Kind::Bool), "BOOL"),
            Literal::I32(_) => (Some(Kind::Dint), "DINT"),
            Literal::U32(_) => (Some(Kind::Udint), "UDINT"),
            Literal::F64(_) => ((self.variables.real == RealKind::F64).then_some(Kind::Real), "LREAL"),
            Literal::F32(_) => ((self.variables.real == RealKind::F32).then_some(Kind::Real), "REAL"),
            Literal::Usize(_) | Literal::Variant(_) => (None, "a type"),
        };
        let fits = |variable: &Variable| Some(variable.kind) == kind && variable.role == role;
        let found = self.variables.single.get(name).filter(fits);
        if found.is_none() {
            let place = if role == Role::Input { "VAR_INPUT" } else { "VAR_OUTPUT" };
            let (line, column) = self.place;
            let found = format!("no `{name} : {ty}` in `{place}`");
            mistakes.push(Mistake { line, column, found, instead: "its declaration".to_owned() });
        }
        found
    }
}

impl Instance<'_> {
    /// The value of a variable by its path, as a bus or a visualisation reads it.
    #[must_use]
    pub fn get(&self, path: &str) -> Option<Literal> {
        let variable = self.block.variables.single.get(path)?;
        Some(match &self.slots {
            Memory::Double(slots) => read(slots, variable),
            Memory::Single(slots) => read(slots, variable),
            Memory::Mixed(slots) => in_single(read(slots, variable)),
        })
    }

    /// Writes a variable by its path, as a bus or a visualisation does; returns false if there is none of this type.
    #[must_use]
    pub fn set(&mut self, path: &str, value: Literal) -> bool {
        let Some(variable) = self.block.variables.single.get(path) else { return false };
        let fits = self.get(path).is_some_and(|now| std::mem::discriminant(&now) == std::mem::discriminant(&value));
        let value = if matches!(self.slots, Memory::Mixed(_)) { in_double(value) } else { value };
        match &mut self.slots {
            _ if !fits => {}
            Memory::Double(slots) | Memory::Mixed(slots) => write(slots, variable, value),
            Memory::Single(slots) => write(slots, variable, value),
        }
        fits
    }

    /// Whether a cycle so far has compared a NaN, which can stop a runtime. A range test by the function `F_axgen_in_range` does not.
    #[must_use]
    pub fn has_compared_a_nan(&self) -> bool {
        match &self.slots {
            Memory::Double(slots) | Memory::Mixed(slots) => slots.compared_a_nan,
            Memory::Single(slots) => slots.compared_a_nan,
        }
    }

    /// One cycle: the values of the inputs in the order of the signals, then those of the outputs.
    pub fn cycle(&mut self, inputs: &[Literal], outputs: &mut Vec<Literal>) {
        let (own, results) = (&self.inputs, (&self.outputs[..], &mut *outputs));
        match &mut self.slots {
            Memory::Double(slots) => cycle::<_, false>(self.block, slots, (own, inputs), results),
            Memory::Single(slots) => cycle::<_, false>(self.block, slots, (own, inputs), results),
            Memory::Mixed(slots) => {
                let inputs: Vec<Literal> = inputs.iter().map(|&value| in_double(value)).collect();
                cycle::<_, true>(self.block, slots, (own, &inputs), results);
                outputs.iter_mut().for_each(|value| *value = in_single(*value));
            }
        }
    }
}

fn cycle<R: Real, const MIXED: bool>(
    block: &Block,
    slots: &mut Slots<R>,
    (inputs, values): (&[Variable], &[Literal]),
    (outputs, results): (&[Variable], &mut Vec<Literal>),
) {
    for (variable, &value) in inputs.iter().zip(values) {
        write(slots, *variable, value);
    }
    slots.cycle::<MIXED>(&block.ops);
    results.clear();
    results.extend(outputs.iter().map(|variable| read(slots, *variable)));
}

fn write<R: Real>(slots: &mut Slots<R>, variable: Variable, value: Literal) {
    let slot = variable.slot as usize;
    match value {
        Literal::Bool(value) => slots.bools[slot] = value,
        Literal::I32(value) => slots.words[slot] = value.cast_unsigned(),
        Literal::U32(value) => slots.words[slot] = value,
        real => slots.reals[slot] = R::from_literal(real),
    }
}

fn read<R: Real>(slots: &Slots<R>, variable: Variable) -> Literal {
    let slot = variable.slot as usize;
    match variable.kind {
        Kind::Real => literal(slots.reals[slot]),
        Kind::Bool => Literal::Bool(slots.bools[slot]),
        Kind::Dint | Kind::Int => Literal::I32(slots.words[slot].cast_signed()),
        Kind::Udint | Kind::Uint => Literal::U32(slots.words[slot]),
    }
}

/// The value with all its bits, including those of a NaN.
fn literal<R: Real>(value: R) -> Literal {
    let mut literal = Literal::F64(0.0);
    value.visit(&mut |own| literal = own);
    literal
}

/// A REAL as stored in the slots of a mixed block.
fn in_double(value: Literal) -> Literal {
    if let Literal::F32(value) = value { Literal::F64(f64::from(value)) } else { value }
}

/// The value in a slot of a mixed block, as a REAL.
fn in_single(value: Literal) -> Literal {
    if let Literal::F64(value) = value { Literal::F32(f32::lit(value)) } else { value }
}
