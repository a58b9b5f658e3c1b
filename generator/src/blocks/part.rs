//! What a block's folder says of it. Nothing is done here.

use super::values::{self, Values};
use crate::axis::Axis;
use crate::blocks::designed::Designed;
use compiler::program::Program;
use portable::Block;

/// A block that an axis may have: a reference with what the axis's parameters make of it.
pub(crate) trait Part: Block<f64> + Block<f32> + Sync {
    /// Whether the parameters of an axis ask for it.
    fn is_asked_for(axis: &Axis) -> bool;

    /// Its coefficients, in double precision.
    fn coefficients(designed: &Designed) -> <Self as Block<f64>>::Coeffs;

    /// What they mean: a path among the coefficients, or the beginning of one, and a text.
    fn notes(designed: &Designed) -> Vec<(String, String)>;

    /// The ranges of the noise on its real inputs in a self-test: where no limit acts, and where limits do.
    fn ranges(designed: &Designed) -> [f64; 2];

    /// What it does, for the summary of an axis.
    fn summary(designed: &Designed) -> Summary;

    /// What it does as named values, for the semantic diff.
    fn values(_: &Designed) -> Values {
        Values::new()
    }

    /// What differs between two versions of an axis, as far as this block shows it: in words, a line each.
    fn differences(old: &Designed, new: &Designed) -> Vec<String> {
        values::differences(&Self::values(old), &Self::values(new))
    }

    /// The same of an axis that has no older version.
    fn description(designed: &Designed) -> Vec<String> {
        values::description(&Self::values(designed))
    }

    /// What is certain of its program, in words, a line each.
    fn certificate(_: &Designed, _: &Program) -> Vec<String> {
        Vec::new()
    }
}

/// What a block does.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// behind the first line of its axis
    pub head: String,
    /// lines of its own
    pub lines: Vec<String>,
}

impl Summary {
    /// Nothing behind the first line of the axis, and a line of its own, if there is one.
    pub(crate) fn line(line: Option<String>) -> Self {
        Self { head: String::new(), lines: line.into_iter().collect() }
    }
}
