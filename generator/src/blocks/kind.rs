//! The products of a block's folder for any type of its reference: verified program, self-test, recorded run.

use super::designed::Designed;
use super::part::{Certified, Part};
use crate::design::rounding::rounded;
use crate::exercise::runner::{self, Runner};
use crate::exercise::{self, Exercise, RecordedAnswers, Run, Running, SelfTest, Trial, Wanted};
use compiler::legalise::{self, AxisProgram};
use compiler::pass::{self, Defect};
use compiler::ranges::{self, Shown};
use compiler::{arithmetic, leaves, program::Program, specialise, structure};
use portable::{Block as Reference, Field, Literal, Portable, Real, RealKind, Ty};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The last pass.
pub(super) const VERIFIED: &str = "verified";

/// A reference that an axis may run.
pub trait Design: Reference<f64> + Reference<f32> + Sync + 'static {
    /// Its coefficients, in double precision.
    fn design(designed: &Designed) -> <Self as Reference<f64>>::Coeffs;

    /// The block that an axis runs instead, if any.
    fn other(_: &Designed) -> Option<&'static dyn Typed> {
        None
    }
}

/// A block that an axis may have.
pub trait BlockKind: Part {
    /// Its name in files and on the command line.
    fn name(&self) -> &'static str;

    /// Its inputs and its outputs with their meanings.
    fn signals(&self) -> [&'static [Field]; 2];

    /// The reference that an axis runs as this block.
    fn typed(&self, designed: &Designed) -> &dyn Typed;
}

impl<P: Part + Design> BlockKind for P {
    fn name(&self) -> &'static str {
        <P as Reference<f64>>::NAME
    }

    fn signals(&self) -> [&'static [Field]; 2] {
        [<P as Reference<f64>>::Inputs::TY, <P as Reference<f64>>::Outputs::TY].map(|ty| match ty {
            Ty::Struct { def } => def.fields,
            Ty::Bool | Ty::I32 | Ty::U32 | Ty::Usize | Ty::Real(_) | Ty::Array { .. } | Ty::Enum { .. } => &[],
        })
    }

    fn typed(&self, designed: &Designed) -> &dyn Typed {
        P::other(designed).unwrap_or(self)
    }
}

impl dyn BlockKind + '_ {
    /// The program after the pass of that name; none: as the specialiser gives it.
    ///
    /// # Errors
    /// A defect of the block or of a pass.
    pub fn program(&self, designed: &Designed, last: Option<&str>) -> Result<Program, Defect> {
        self.typed(designed).program(self, designed, last)
    }

    /// The ranges of its outputs for any state and any inputs.
    ///
    /// # Errors
    /// A defect of the block or of a pass.
    pub fn shown(&self, designed: &Designed) -> Result<Shown, Defect> {
        Ok(shown(self, designed, &self.program(designed, Some(VERIFIED))?))
    }

    /// The block, ready to be printed.
    ///
    /// # Errors
    /// A defect of the block or of a pass.
    pub fn block(&self, designed: &Designed) -> Result<Block, Defect> {
        self.typed(designed).block(self, designed)
    }

    /// A run of N samples of an axis's block, for a user's own board.
    pub fn runner(&self, designed: &Designed, block: &Block, samples: usize) -> Runner {
        runner::record(&block.exercise, &mut *self.start(designed), samples)
    }

    /// The reference, before its first cycle.
    pub fn start(&self, designed: &Designed) -> Box<dyn Run> {
        self.typed(designed).start(designed)
    }

    /// All its coefficients.
    pub fn coefficients(&self, designed: &Designed) -> Vec<Literal> {
        self.typed(designed).coefficients(designed)
    }
}

/// A reference in the real type of an axis; `part`: what its block's folder says. Each does what the function of this
/// name of [`BlockKind`] does.
pub trait Typed: Sync {
    #[expect(clippy::missing_errors_doc, reason = "that of BlockKind")]
    fn program(&self, part: &dyn Part, designed: &Designed, last: Option<&str>) -> Result<Program, Defect>;
    #[expect(clippy::missing_errors_doc, reason = "that of BlockKind")]
    fn block(&self, part: &dyn Part, designed: &Designed) -> Result<Block, Defect>;
    fn start(&self, designed: &Designed) -> Box<dyn Run>;
    fn coefficients(&self, designed: &Designed) -> Vec<Literal>;
}

impl<B: Design> Typed for B {
    fn program(&self, part: &dyn Part, designed: &Designed, last: Option<&str>) -> Result<Program, Defect> {
        match designed.axis.real {
            RealKind::F64 => program::<f64, B>(part, designed, last),
            RealKind::F32 => program::<f32, B>(part, designed, last),
        }
    }

    fn block(&self, part: &dyn Part, designed: &Designed) -> Result<Block, Defect> {
        match designed.axis.real {
            RealKind::F64 => block::<f64, B>(part, designed),
            RealKind::F32 => block::<f32, B>(part, designed),
        }
    }

    fn start(&self, designed: &Designed) -> Box<dyn Run> {
        let (coeffs, real) = (B::design(designed), designed.axis.real);
        match real {
            RealKind::F64 => Box::new(Running::<f64, B>::start(coeffs)),
            RealKind::F32 => Box::new(Running::<f32, B>::start(rounded(&coeffs, real))),
        }
    }

    fn coefficients(&self, designed: &Designed) -> Vec<Literal> {
        let (coeffs, real) = (B::design(designed), designed.axis.real);
        match real {
            RealKind::F64 => leaves(&coeffs),
            RealKind::F32 => leaves(&rounded::<_, <B as Reference<f32>>::Coeffs>(&coeffs, real)),
        }
    }
}

/// The program after the pass of that name; with `None`, the output of the specialiser.
fn program<R: Real, B: Design + Reference<R>>(
    part: &dyn Part,
    designed: &Designed,
    last: Option<&str>,
) -> Result<Program, Defect> {
    let notes = part.notes(designed).into_iter().collect();
    let specialised = specialise::block::<R, B>(&rounded(&B::design(designed), R::KIND), &notes);
    if last.is_some() { pass::run(specialised, last) } else { Ok(specialised) }
}

/// Specialises one block and records its run.
fn block<R: Real, B: Design + Reference<R>>(part: &dyn Part, designed: &Designed) -> Result<Block, Defect> {
    let coeffs = || rounded(&B::design(designed), R::KIND);
    let notes = part.notes(designed).into_iter().collect();
    let specialised = specialise::block::<R, B>(&coeffs(), &notes);
    let structure = structure::of(&specialised);
    let state_paths: Vec<String> = specialised.state.iter().map(|variable| variable.path.clone()).collect();
    let program = pass::run(specialised, None)?;
    let own = legalise::own(&program)?;
    let certificate = part.certificate(designed, &program)?;
    let wanted = Wanted {
        ranges: part.ranges(designed),
        start: part.start_cycles(designed),
        drill: part.drill(designed),
        cycle_time_ns: designed.axis.cycle_time_ns,
    };
    let exercise = Arc::new(Exercise::of::<R, B>(&coeffs(), (&program, &own), &state_paths, &wanted));
    let self_test = SelfTest::record(&exercise, &mut Running::<R, B>::start(coeffs()));
    let trial = Trial::of(&exercise);
    let numbers = coeffs();
    let start = || Box::new(Running::<R, B>::start(numbers)) as Box<dyn Run>;
    let answers = exercise::recording(trial.clone(), &program, &state_paths, start);
    let shown = shown(part, designed, &program);
    shown.refuse(program.block)?;
    Ok(Block { program, own, notes, exercise, self_test, trial, answers, certificate, shown, structure })
}

/// The ranges of the outputs of a program.
fn shown(part: &dyn Part, designed: &Designed, program: &Program) -> Shown {
    // If nothing adds a velocity, the limit is 0.
    let limit = part.limit(designed).and_then(|figure| arithmetic::wide(figure.value)).unwrap_or(0.0);
    ranges::run(program, &["v_add", "v_add_calculated", "v_excite"].map(|path| (path, limit)))
}

/// A block of one axis, ready to be printed.
#[derive(Clone, Debug)]
pub struct Block {
    /// after the last pass
    pub program: Program,
    /// the same with the signals that the axis has
    pub own: AxisProgram,
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
    /// The inputs of its self-test on the controller, sample by sample.
    pub fn trial_inputs(&self) -> Vec<Vec<Literal>> {
        self.trial.inputs()
    }
}
