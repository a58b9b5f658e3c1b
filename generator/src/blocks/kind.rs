//! The interface of a block's folder, and that of its reference, without its real type. No product is made here.

use super::block::{Block, Certified, Figure};
use super::designed::Designed;
use super::effects::{self, Effects};
use super::ipc::row::StageRow;
use crate::axis::Axis;
use crate::exercise::{Drill, Run};
use compiler::pass::Defect;
use compiler::program::Program;
use portable::{Block as Reference, Field, Literal, Real, RealKind};

/// The interface of a block's folder: the results of an axis's parameters for a reference.
pub trait BlockKind: Typed {
    /// Whether the parameters of an axis ask for it.
    fn is_asked_for(&self, axis: &Axis) -> bool;

    /// Its name where names have to be short.
    fn short_name(&self) -> &'static str;

    /// What it is for, what its first call does, and what happens while it is not called: for the head of its files.
    fn purpose(&self, designed: &Designed) -> String;

    /// The meanings of its coefficients: a path among them, or the beginning of one, and a text.
    fn notes(&self, designed: &Designed) -> Vec<(String, String)>;

    /// Values from other blocks of its axis that the parameter digest must cover.
    fn terms(&self, _: &Axis) -> String {
        String::new()
    }

    /// The ranges of the noise on its real inputs in a self-test: without and with limiting.
    fn ranges(&self, designed: &Designed) -> [f64; 2];

    /// The number of cycles from its start until it acts in full.
    fn start_cycles(&self, _: &Designed) -> usize {
        0
    }

    /// The sequences of its self-test, in addition to noise.
    fn drill(&self, _: &Designed) -> Vec<Drill> {
        Vec::new()
    }

    /// Its effect, for the summary of an axis.
    fn summary(&self, designed: &Designed) -> Summary;

    /// Its meaning for the machine: in detail, one line each.
    fn details(&self, designed: &Designed) -> Details {
        Details { stages: Vec::new(), lines: self.summary(designed).lines }
    }

    /// Its effects by their names, for the semantic diff.
    fn effects(&self, _: &Designed) -> Effects {
        Effects::new()
    }

    /// The differences between two versions of an axis in this block, in words, one line each.
    fn differences(&self, old: &Designed, new: &Designed) -> Vec<String> {
        effects::differences(&self.effects(old), &self.effects(new))
    }

    /// Its effects on an axis that has no older version, in words, one line each.
    fn added(&self, designed: &Designed) -> Vec<String> {
        effects::added(&self.effects(designed))
    }

    /// The largest |v_add| or |v_excite|, if it has this output.
    fn limit(&self, _: &Designed) -> Option<Figure> {
        None
    }

    /// The proven properties of its program: its limit, if it has one.
    ///
    /// # Errors
    /// The program does not do what was designed.
    fn certificate(&self, designed: &Designed, _: &Program) -> Result<Certified, Defect> {
        Ok(Certified { figures: self.limit(designed).into_iter().collect(), ..Certified::default() })
    }
}

/// The summary of a block.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// the text after the first line of its axis
    pub head: String,
    /// separate lines
    pub lines: Vec<String>,
}

/// The meaning of a block for the machine.
#[derive(Clone, Debug, Default)]
pub struct Details {
    /// those of improved position control
    pub stages: Vec<StageRow>,
    /// all of it in words
    pub lines: Vec<String>,
}

/// A reference that an axis may run.
pub trait Design: Reference<f64> + Reference<<Self as Design>::Single> + Sync + 'static {
    /// The real type with which it computes on an axis in single precision.
    type Single: Real;

    /// Its coefficients, in double precision.
    fn design(designed: &Designed) -> <Self as Reference<f64>>::Coeffs;

    /// The block that an axis runs instead, if any.
    fn other(_: &Designed) -> Option<&'static dyn Typed> {
        None
    }
}

/// A reference in the real type of an axis. `kind`: the folder of its block.
pub trait Typed: Sync {
    /// The name of its block in files and on the command line.
    fn name(&self) -> &'static str;
    /// The inputs and the outputs of its block with their meanings.
    fn signals(&self) -> [&'static [Field]; 2];
    /// The real type with which an axis's block computes.
    fn computes_in(&self, designed: &Designed) -> RealKind;
    /// The reference that an axis runs.
    fn typed(&self, designed: &Designed) -> &dyn Typed;
    #[expect(clippy::missing_errors_doc, reason = "that of BlockKind")]
    /// The program after the pass of that name.
    fn specialise(&self, kind: &dyn BlockKind, designed: &Designed, last: Option<&str>) -> Result<Program, Defect>;
    #[expect(clippy::missing_errors_doc, reason = "that of BlockKind")]
    fn make(&self, kind: &dyn BlockKind, designed: &Designed) -> Result<Block, Defect>;
    fn run(&self, designed: &Designed) -> Box<dyn Run>;
    fn numbers(&self, designed: &Designed) -> Vec<Literal>;
    /// The path of each of its coefficients.
    fn coefficient_paths(&self) -> Vec<String>;
}
