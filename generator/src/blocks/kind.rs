//! A block as its folder describes it, and as the registry has it: everything that can be asked of it, whatever its types are.

use super::build::{self, Block};
use super::designed::Designed;
use super::values::{self, Values};
use crate::noise::{Run, Running};
use crate::{axis::Axis, design::rounding::rounded};
use compiler::{leaves, pass::Defect, program::Program};
use portable::{Block as Reference, Literal, RealKind};

/// What a block's folder says of it: what the parameters of an axis make of a reference.
pub trait Part: Sync {
    /// Whether the parameters of an axis ask for it.
    fn is_asked_for(&self, axis: &Axis) -> bool;

    /// Its coefficients, in double precision.
    fn design(designed: &Designed) -> <Self as Reference<f64>>::Coeffs
    where
        Self: Reference<f64> + Sized;

    /// What its coefficients mean: a path among them, or the beginning of one, and a text.
    fn notes(&self, designed: &Designed) -> Vec<(String, String)>;

    /// The ranges of the noise on its real inputs in a self-test: where no limit acts, and where limits do.
    fn ranges(&self, designed: &Designed) -> [f64; 2];

    /// What it does, for the summary of an axis.
    fn summary(&self, designed: &Designed) -> Summary;

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

    /// What is certain of its program, in words, a line each.
    fn certificate(&self, _: &Designed, _: &Program) -> Vec<String> {
        Vec::new()
    }
}

/// A block that an axis may have, in the real type of the axis.
pub trait Kind: Part {
    /// Its name in files and on the command line.
    fn name(&self) -> &'static str;

    /// The program after the pass of that name; none: as the specialiser gives it.
    ///
    /// # Errors
    /// A defect of the block or of a pass.
    fn program(&self, designed: &Designed, last: Option<&str>) -> Result<Program, Defect>;

    /// The block, ready to be printed.
    ///
    /// # Errors
    /// A defect of the block or of a pass.
    fn block(&self, designed: &Designed) -> Result<Block, Defect>;

    /// The reference, before its first cycle.
    fn start(&self, designed: &Designed) -> Box<dyn Run>;

    /// All its coefficients.
    fn coefficients(&self, designed: &Designed) -> Vec<Literal>;
}

impl<P: Part + Reference<f64> + Reference<f32> + 'static> Kind for P {
    fn name(&self) -> &'static str {
        <P as Reference<f64>>::NAME
    }

    fn program(&self, designed: &Designed, last: Option<&str>) -> Result<Program, Defect> {
        match designed.axis.real {
            RealKind::F64 => build::program::<f64, P>(self, designed, last),
            RealKind::F32 => build::program::<f32, P>(self, designed, last),
        }
    }

    fn block(&self, designed: &Designed) -> Result<Block, Defect> {
        match designed.axis.real {
            RealKind::F64 => build::block::<f64, P>(self, designed),
            RealKind::F32 => build::block::<f32, P>(self, designed),
        }
    }

    fn start(&self, designed: &Designed) -> Box<dyn Run> {
        let (coeffs, real) = (P::design(designed), designed.axis.real);
        match real {
            RealKind::F64 => Box::new(Running::<f64, P>::start(coeffs)),
            RealKind::F32 => Box::new(Running::<f32, P>::start(rounded(&coeffs, real))),
        }
    }

    fn coefficients(&self, designed: &Designed) -> Vec<Literal> {
        let (coeffs, real) = (P::design(designed), designed.axis.real);
        match real {
            RealKind::F64 => leaves(&coeffs),
            RealKind::F32 => leaves(&rounded::<_, <P as Reference<f32>>::Coeffs>(&coeffs, real)),
        }
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
