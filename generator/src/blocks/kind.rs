//! The interface of a block's folder, and the types of its results. Derived results are in `products`.

use super::designed::Designed;
use super::effects::{self, Effects};
use super::products::Typed;
use crate::axis::Axis;
use crate::exercise::Drill;
use compiler::pass::Defect;
use compiler::program::Program;
use portable::Literal;

/// The interface of a block's folder: the results of an axis's parameters for a reference.
pub trait BlockKind: Typed {
    /// Whether the parameters of an axis ask for it.
    fn is_asked_for(&self, axis: &Axis) -> bool;

    /// Its name where names have to be short.
    fn short_name(&self) -> &'static str;

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
    fn details(&self, designed: &Designed) -> Vec<String> {
        self.summary(designed).lines
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

    /// The proven properties of its program.
    ///
    /// # Errors
    /// The program does not do what was designed.
    fn certificate(&self, _: &Designed, _: &Program) -> Result<Certified, Defect> {
        Ok(Certified::default())
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
