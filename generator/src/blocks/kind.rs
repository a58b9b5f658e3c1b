//! A block as the registry has it: everything that can be asked of it, whatever its types are.

use super::build::{self, Block};
use super::part::{Part, Summary};
use crate::axis::Axis;
use crate::blocks::designed::Designed;
use crate::design::rounding::rounded;
use compiler::leaves;
use compiler::pass::Defect;
use compiler::program::Program;
use portable::{Block as Reference, Literal, Portable, Real, RealKind};

/// A block that an axis may have.
pub trait Kind: Sync {
    /// Its name in files and on the command line.
    fn name(&self) -> &'static str;

    /// Whether the parameters of an axis ask for it.
    fn is_asked_for(&self, axis: &Axis) -> bool;

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

    /// All its coefficients, in its own real type.
    fn coefficients(&self, designed: &Designed) -> Vec<Literal>;

    /// What its coefficients mean: a path among them, or the beginning of one, and a text.
    fn notes(&self, designed: &Designed) -> Vec<(String, String)>;

    /// What it does, for the summary of an axis.
    fn summary(&self, designed: &Designed) -> Summary;

    /// What differs between two versions of an axis, a line each.
    fn differences(&self, old: &Designed, new: &Designed) -> Vec<String>;

    /// The same of an axis that has no older version.
    fn description(&self, designed: &Designed) -> Vec<String>;
}

/// A reference in operation.
pub trait Run {
    /// One cycle: takes the scalars of the inputs, gives those of the outputs.
    fn step(&mut self, inputs: &[Literal], outputs: &mut Vec<Literal>);

    /// The scalars of its state.
    fn state(&self) -> Vec<Literal>;
}

impl<P: Part + 'static> Kind for P {
    fn name(&self) -> &'static str {
        <P as Reference<f64>>::NAME
    }

    fn is_asked_for(&self, axis: &Axis) -> bool {
        P::is_asked_for(axis)
    }

    fn program(&self, designed: &Designed, last: Option<&str>) -> Result<Program, Defect> {
        match designed.axis.real {
            RealKind::F64 => build::program::<f64, P>(designed, last),
            RealKind::F32 => build::program::<f32, P>(designed, last),
        }
    }

    fn block(&self, designed: &Designed) -> Result<Block, Defect> {
        match designed.axis.real {
            RealKind::F64 => build::block::<f64, P>(designed),
            RealKind::F32 => build::block::<f32, P>(designed),
        }
    }

    fn start(&self, designed: &Designed) -> Box<dyn Run> {
        match designed.axis.real {
            RealKind::F64 => Box::new(Running::<f64, P>::start(designed)),
            RealKind::F32 => Box::new(Running::<f32, P>::start(designed)),
        }
    }

    fn coefficients(&self, designed: &Designed) -> Vec<Literal> {
        let coeffs = P::coefficients(designed);
        match designed.axis.real {
            RealKind::F64 => leaves(&coeffs),
            RealKind::F32 => leaves(&rounded::<_, <P as Reference<f32>>::Coeffs>(&coeffs, RealKind::F32)),
        }
    }

    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        P::notes(designed)
    }

    fn summary(&self, designed: &Designed) -> Summary {
        P::summary(designed)
    }

    fn differences(&self, old: &Designed, new: &Designed) -> Vec<String> {
        P::differences(old, new)
    }

    fn description(&self, designed: &Designed) -> Vec<String> {
        P::description(designed)
    }
}

/// A reference with its state.
struct Running<R: Real, B: Reference<R>> {
    coeffs: B::Coeffs,
    state: B::State,
    outputs: B::Outputs,
}

impl<R: Real, P: Part + Reference<R>> Running<R, P> {
    fn start(designed: &Designed) -> Self {
        let coeffs = rounded(&P::coefficients(designed), R::KIND);
        Self { coeffs, state: <P as Reference<R>>::state(), outputs: <P as Reference<R>>::outputs() }
    }
}

impl<R: Real, B: Reference<R>> Run for Running<R, B> {
    fn step(&mut self, inputs: &[Literal], outputs: &mut Vec<Literal>) {
        let mut next = inputs.iter().copied();
        let inputs = B::Inputs::build(&mut || next.next().expect("kind: as many values as inputs"));
        B::step(&mut self.state, &self.coeffs, &inputs, &mut self.outputs);
        outputs.clear();
        self.outputs.visit(&mut |output| outputs.push(output));
    }

    fn state(&self) -> Vec<Literal> {
        leaves(&self.state)
    }
}
