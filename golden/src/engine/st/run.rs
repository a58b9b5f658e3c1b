//! Runs a block over samples, from a fresh instance.

use super::declarations::{Kind, Role, Variable};
use super::machine::Slots;
use super::{Block, Mistake};
use crate::samples::{Samples, Shape};
use compiler::program::Type;
use portable::{Literal, Real, RealKind};

impl Block {
    /// Runs it from a fresh instance. `input_names` and `output_names` are in the order of the signals, in whatever case;
    /// `set` gives further inputs of type BOOL a value for the whole run. Every other input keeps its value at the start.
    ///
    /// # Errors
    /// A name is not that of an input or output of the signal's type.
    pub fn run(
        &self,
        inputs: &Samples,
        input_names: &[String],
        outputs: &Shape,
        output_names: &[String],
        set: &[(&str, bool)],
    ) -> Result<Samples, Vec<Mistake>> {
        let mut mistakes = Vec::new();
        let sources = self.signals(&inputs.shape, input_names, Role::Input, &mut mistakes);
        let sinks = self.signals(outputs, output_names, Role::Output, &mut mistakes);
        let mut start = self.variables.slots.clone();
        for &(name, value) in set {
            if let Some(variable) = self.signal(name, Kind::Bool, Role::Input, &mut mistakes) {
                start.bools[variable.slot as usize] = value;
            }
        }
        if !mistakes.is_empty() {
            return Err(mistakes);
        }
        let samples = Samples::with_capacity(outputs.clone(), inputs.len());
        Ok(match self.variables.real {
            RealKind::F64 => self.run_as(Slots::<f64>::start(&start), inputs, &sources, samples, &sinks),
            RealKind::F32 => self.run_as(Slots::<f32>::start(&start), inputs, &sources, samples, &sinks),
        })
    }

    fn run_as<R: Real>(
        &self,
        mut slots: Slots<R>,
        inputs: &Samples,
        sources: &[Variable],
        mut samples: Samples,
        sinks: &[Variable],
    ) -> Samples {
        let (mut values, mut results) = (Vec::new(), Vec::new());
        for sample in 0..inputs.len() {
            inputs.read(sample, &mut values);
            for (variable, &value) in sources.iter().zip(&values) {
                write(&mut slots, *variable, value);
            }
            slots.cycle(&self.ops);
            results.clear();
            results.extend(sinks.iter().map(|variable| read(&slots, *variable)));
            samples.push(&results);
        }
        samples
    }

    /// The variables of the signals, or what is wrong with them.
    fn signals(&self, shape: &Shape, names: &[String], role: Role, mistakes: &mut Vec<Mistake>) -> Vec<Variable> {
        if shape.signals.len() != names.len() {
            let found = format!("{} signals and {} names", shape.signals.len(), names.len());
            mistakes.push(self.mistake(found, "a name for each signal"));
        }
        if shape.real != self.variables.real {
            let name = Kind::Real.name(self.variables.real);
            mistakes.push(self.mistake("signals of another real type".to_owned(), name));
        }
        let kind = |ty| match ty {
            Type::Real => Kind::Real,
            Type::Bool => Kind::Bool,
            Type::I32 => Kind::Dint,
            Type::U32 => Kind::Udint,
        };
        let pairs = shape.signals.iter().zip(names);
        pairs.filter_map(|(signal, name)| self.signal(name, kind(signal.ty), role, mistakes)).collect()
    }

    fn signal(&self, name: &str, kind: Kind, role: Role, mistakes: &mut Vec<Mistake>) -> Option<Variable> {
        let found = self.variables.find(name).filter(|variable| variable.kind == kind && variable.role == role);
        if found.is_none() {
            let place = if role == Role::Input { "VAR_INPUT" } else { "VAR_OUTPUT" };
            let ty = kind.name(self.variables.real);
            mistakes.push(self.mistake(format!("no `{name} : {ty}` in `{place}`"), "its declaration"));
        }
        found
    }

    fn mistake(&self, found: String, instead: &str) -> Mistake {
        let (line, column) = self.place;
        Mistake { line, column, found, instead: instead.to_owned() }
    }
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
        Kind::Dint => Literal::I32(slots.words[slot].cast_signed()),
        Kind::Udint => Literal::U32(slots.words[slot]),
    }
}

/// The value with all its bits, a NaN's too.
fn literal<R: Real>(value: R) -> Literal {
    let mut literal = Literal::F64(0.0);
    value.visit(&mut |own| literal = own);
    literal
}
