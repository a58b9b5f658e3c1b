//! The reference of a block in a loop: its inputs and outputs by name, cycle by cycle, and the record of both. No machine, no
//! program.

use crate::csv::{self, Reals};
use crate::engine::{self, Cycle};
use crate::samples::{Samples, Shape};
use compiler::program::Type;
use generator::blocks::{Block, Designed};
use machine::closed_loop::Signals;
use portable::{Literal, RealKind};

/// A block between two cycles.
pub struct Subject {
    step: Cycle,
    given: Vec<Literal>,
    answers: Vec<Literal>,
    /// its inputs and outputs so far
    pub inputs: Samples,
    pub outputs: Samples,
}

impl Subject {
    /// The state before the first cycle, with the start values of its inputs.
    ///
    /// # Panics
    /// If the axis does not have the block.
    #[must_use]
    pub fn start(designed: &Designed, block: &Block) -> Self {
        let shape = |variables| Shape::of(variables, block.program.real);
        let (inputs, outputs) = (shape(&block.program.inputs), shape(&block.program.outputs));
        let start = |shape: &Shape| shape.signals.iter().map(|signal| signal.start.at_run_time()).collect();
        Self {
            step: engine::start(designed, block),
            given: start(&inputs),
            answers: start(&outputs),
            inputs: Samples::with_capacity(inputs, 0),
            outputs: Samples::with_capacity(outputs, 0),
        }
    }

    /// Sets an input from this cycle on; returns whether the block has it.
    pub fn set(&mut self, name: &str, value: f64) -> bool {
        let Some(at) = self.inputs.shape.place(name) else { return false };
        self.given[at] = literal(value, self.inputs.shape.signals[at].ty, self.inputs.shape.real);
        true
    }

    /// The present value of an input, initially its start value. `None` if the block does not have it.
    #[must_use]
    pub fn input(&self, name: &str) -> Option<f64> {
        self.inputs.shape.place(name).map(|at| number(self.given[at]))
    }

    /// The value of an output in the last cycle, initially its start value. `None` if the block does not have it.
    #[must_use]
    pub fn output(&self, name: &str) -> Option<f64> {
        self.outputs.shape.place(name).map(|at| number(self.answers[at]))
    }

    /// The value of an output in the last cycle; 0 if the block does not have it.
    #[must_use]
    pub fn get(&self, name: &str) -> f64 {
        self.output(name).unwrap_or(0.0)
    }

    /// One cycle.
    pub fn step(&mut self) {
        self.inputs.push(&self.given);
        (self.step)(&self.given, &mut self.answers);
        self.outputs.push(&self.answers);
    }

    /// One cycle with the inputs of improved position control; returns `v_add` [um/s].
    pub fn cycle(&mut self, signals: &Signals) -> f64 {
        let Signals { v_command, v_motor, v_direct } = *signals;
        for (input, value) in [("v_command", v_command), ("v_motor", v_motor), ("v_direct", v_direct)] {
            self.set(input, value);
        }
        self.step();
        self.get("v_add")
    }

    /// Clears the record of inputs and outputs.
    pub fn record_anew(&mut self) {
        self.inputs.bytes.clear();
        self.outputs.bytes.clear();
    }

    /// The record of inputs and outputs as CSV, since it was cleared or since the start.
    #[must_use]
    pub fn csv(&self) -> String {
        csv::write(&[&self.inputs, &self.outputs], Reals::Decimal)
    }
}

/// A value of a signal as a number, which is exact for every value.
#[must_use]
pub fn number(value: Literal) -> f64 {
    match value {
        Literal::Bool(value) => f64::from(u8::from(value)),
        Literal::I32(value) => f64::from(value),
        Literal::U32(value) => f64::from(value),
        Literal::F32(value) => f64::from(value),
        Literal::F64(value) => value,
        Literal::Usize(_) | Literal::Variant(_) => 0.0,
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates; reals are rounded once, here")]
pub(crate) fn literal(value: f64, ty: Type, real: RealKind) -> Literal {
    match (ty, real) {
        (Type::Bool, _) => Literal::Bool(value != 0.0),
        (Type::I32, _) => Literal::I32(value as i32),
        (Type::U32, _) => Literal::U32(value as u32),
        (Type::Real, RealKind::F64) => Literal::F64(value),
        (Type::Real, RealKind::F32) => Literal::F32(value as f32),
    }
}
