//! What a block's folder says of it, and the forms in which it says it. What follows is in `kind`.

use super::designed::Designed;
use super::values::{self, Values};
use crate::axis::Axis;
use crate::exercise::Drill;
use compiler::pass::Defect;
use compiler::program::Program;
use portable::Literal;

/// What a block's folder says of it: what the parameters of an axis make of a reference.
pub trait Part: Sync {
    /// Whether the parameters of an axis ask for it.
    fn is_asked_for(&self, axis: &Axis) -> bool;

    /// What it is called where names have to be short.
    fn short_name(&self) -> &'static str;

    /// What its coefficients mean: a path among them, or the beginning of one, and a text.
    fn notes(&self, designed: &Designed) -> Vec<(String, String)>;

    /// What it takes from other blocks of its axis next to parameters, for the digest.
    fn terms(&self, _: &Axis) -> String {
        String::new()
    }

    /// The ranges of the noise on its real inputs in a self-test: where no limit acts, and where limits do.
    fn ranges(&self, designed: &Designed) -> [f64; 2];

    /// How many cycles it takes from its start until it acts in full.
    fn start_cycles(&self, _: &Designed) -> usize {
        0
    }

    /// What it is led through in a self-test, in addition to noise.
    fn drill(&self, _: &Designed) -> Vec<Drill> {
        Vec::new()
    }

    /// What it does, for the summary of an axis.
    fn summary(&self, designed: &Designed) -> Summary;

    /// What it means for the machine: tables and verdicts in words, a line each.
    fn verdict(&self, designed: &Designed) -> Vec<String> {
        self.summary(designed).lines
    }

    /// What it does as named values, for the semantic diff.
    fn values(&self, _: &Designed) -> Values {
        Values::new()
    }

    /// What differs between two versions of an axis, as far as this block shows it: in words, a line each.
    fn differences(&self, old: &Designed, new: &Designed) -> Vec<String> {
        values::differences(&self.values(old), &self.values(new))
    }

    /// The same of an axis that has no older version.
    fn description(&self, designed: &Designed) -> Vec<String> {
        values::description(&self.values(designed))
    }

    /// The largest |v_add| or |v_excite|, where it puts one out.
    fn limit(&self, _: &Designed) -> Option<Figure> {
        None
    }

    /// What is certain of its program.
    ///
    /// # Errors
    /// The program does something else than what was designed.
    fn certificate(&self, _: &Designed, _: &Program) -> Result<Certified, Defect> {
        Ok(Certified::default())
    }
}

/// What a block does.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// after the first line of its axis
    pub head: String,
    /// lines of its own
    pub lines: Vec<String>,
}

/// What is certain of a block.
#[derive(Clone, Debug, Default)]
pub struct Certified {
    /// in words, a line each
    pub lines: Vec<String>,
    /// for code
    pub figures: Vec<Figure>,
}

/// A number that code may compare with what it expects.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// in capital letters
    pub name: &'static str,
    /// what it is, with its unit
    pub doc: String,
    /// in the real type of the block
    pub value: Literal,
}
