//! The reference of a block in the loop: what it gets and gives by name, cycle by cycle, and the record of both. No motion.

use super::refused;
use crate::engine::{self, Cycle};
use crate::samples::{Samples, Shape};
use compiler::program::Type;
use generator::blocks::{Block, Designed};
use nc::Mistake;
use portable::{Literal, RealKind};

/// Longer scenarios are a mistake of their program.
const MOST: usize = 200_000;

/// A block in the loop.
pub(super) struct Recorder {
    step: Cycle,
    given: Vec<Literal>,
    answers: Vec<Literal>,
    pub(super) inputs: Samples,
    pub(super) outputs: Samples,
}

impl Recorder {
    pub(super) fn start(designed: &Designed, block: &Block) -> Self {
        let shape = |variables| Shape::of(variables, designed.axis.real);
        let (inputs, outputs) = (shape(&block.program.inputs), shape(&block.program.outputs));
        let start = |shape: &Shape| shape.signals.iter().map(|signal| signal.start).collect();
        Self {
            step: engine::start(designed, block),
            given: start(&inputs),
            answers: start(&outputs),
            inputs: Samples::with_capacity(inputs, 0),
            outputs: Samples::with_capacity(outputs, 0),
        }
    }

    /// Sets an input from this cycle on; one that the block does not have is passed over.
    pub(super) fn set(&mut self, name: &str, value: f64) {
        let Some(at) = self.inputs.shape.place(name) else { return };
        self.given[at] = literal(value, self.inputs.shape.signals[at].ty, self.inputs.shape.real);
    }

    /// What the block gave in the cycle before; none: it does not have the output.
    pub(super) fn output(&self, name: &str) -> Option<f64> {
        let at = self.outputs.shape.place(name)?;
        Some(number(self.answers[at]))
    }

    /// What the block gave in the cycle before; of an output that it does not have 0.
    pub(super) fn get(&self, name: &str) -> f64 {
        self.output(name).unwrap_or(0.0)
    }

    /// One cycle.
    pub(super) fn cycle(&mut self, line: usize) -> Result<(), Mistake> {
        if self.inputs.len() >= MOST {
            let found = format!("a block that is not over after {MOST} cycles of the scenario");
            return Err(refused(line, found, "a scenario that ends", "another program, or a longer cycle time"));
        }
        self.inputs.push(&self.given);
        (self.step)(&self.given, &mut self.answers);
        self.outputs.push(&self.answers);
        if self.get("fault") != 0.0 {
            let found = format!("error {} of the block at sample {}", self.get("error_id"), self.inputs.len() - 1);
            let instead = "other parameters, or another program; `axgen explain` says what the error means";
            return Err(refused(line, found, "a scenario without an error", instead));
        }
        Ok(())
    }
}

/// A value of a signal as a number; every value of a signal is one exactly.
pub(crate) fn number(value: Literal) -> f64 {
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
