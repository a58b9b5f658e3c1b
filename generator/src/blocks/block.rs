//! A block of an axis, ready to be printed, with its proven properties: data.

use super::IPC;
use crate::exercise::{Exercise, RecordedAnswers, SelfTest, Trial};
use compiler::legalise::AxisProgram;
use compiler::{program::Program, ranges::Shown};
use portable::Literal;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A block of one axis, ready to be printed.
#[derive(Clone, Debug)]
pub struct Block {
    /// after the last pass
    pub program: Program,
    /// the same with the signals that the axis has
    pub for_axis: AxisProgram,
    /// what it is for, what its first call does, and what happens while it is not called
    pub(crate) purpose: String,
    /// what the coefficients under a path mean, for a reviewer
    pub(crate) notes: BTreeMap<String, String>,
    pub(crate) exercise: Arc<Exercise>,
    pub(crate) self_test: SelfTest,
    pub(crate) trial: Trial,
    /// what the reference answers in the trial
    pub(crate) answers: RecordedAnswers,
    /// what is certain of its range, and its measured response
    pub certificate: Certified,
    /// the ranges of its outputs for any state and any inputs
    pub shown: Shown,
    /// its structure without the values of its coefficients: equal text, equal structure
    pub structure: String,
}

impl Block {
    /// Whether the type of its parameter set is declared in the files of another block of its axis: `ipc`.
    pub fn shares_set(&self) -> bool {
        let takes_one = self.program.set.is_some() && self.program.block != IPC;
        takes_one || self.program.made.is_some()
    }

    /// The outputs in a record of a run, by their positions: all, but of a block that makes a parameter set those of its axis.
    pub fn recorded_outputs(&self) -> Vec<usize> {
        if self.program.made.is_some() {
            self.for_axis.outputs.clone()
        } else {
            (0..self.program.outputs.len()).collect()
        }
    }

    /// The inputs of its self-test on the controller, sample by sample.
    pub fn trial_inputs(&self) -> Vec<Vec<Literal>> {
        self.trial.inputs()
    }
}

/// The proven properties of a block.
#[derive(Clone, Debug, Default)]
pub struct Certified {
    /// in words, a line each
    pub lines: Vec<String>,
    /// for code
    pub figures: Vec<Figure>,
}

/// A number that a program may compare with its expected value.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// in capital letters
    pub name: &'static str,
    /// meaning and unit
    pub doc: String,
    /// in the real type of the block
    pub value: Literal,
}
