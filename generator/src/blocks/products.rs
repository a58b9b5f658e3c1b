//! The products of a block's folder for any type of its reference: verified program, self-test, recorded run.

use super::block::Block;
use super::designed::Designed;
use super::kind::{Arithmetic, BlockKind, Design, Typed};
use crate::design::rounding::rounded;
use crate::exercise::runner::{self, Runner};
use crate::exercise::{self, Exercise, Run, Running, SelfTest, Trial, Wanted};
use compiler::legalise;
use compiler::pass::{self, Defect};
use compiler::ranges::{self, Shown};
use compiler::{arithmetic, leaves, program::Program, specialise, structure};
use portable::{Block as Reference, Field, Literal, Portable, Real, Ty, Wide};
use std::sync::Arc;

/// The last pass.
pub(super) const VERIFIED: &str = "verified";

impl dyn BlockKind + '_ {
    /// The program after the pass of that name; none: as the specialiser gives it.
    ///
    /// # Errors
    /// A defect of the block or of a pass.
    pub fn program(&self, designed: &Designed, last: Option<&str>) -> Result<Program, Defect> {
        self.typed(designed).specialise(self, designed, last)
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
        self.typed(designed).make(self, designed)
    }

    /// A run of N samples of an axis's block, for a user's own board.
    pub fn runner(&self, designed: &Designed, block: &Block, samples: usize) -> Runner {
        runner::record(&block.exercise, &mut *self.start(designed), samples)
    }

    /// The reference, before its first cycle.
    pub fn start(&self, designed: &Designed) -> Box<dyn Run> {
        self.typed(designed).run(designed)
    }

    pub fn coefficients(&self, designed: &Designed) -> Vec<Literal> {
        self.typed(designed).numbers(designed)
    }
}

impl<B: Design> Typed for B {
    fn name(&self) -> &'static str {
        <B as Reference<f64>>::NAME
    }

    fn signals(&self) -> [&'static [Field]; 2] {
        [<B as Reference<f64>>::Inputs::TY, <B as Reference<f64>>::Outputs::TY].map(|ty| fields(&ty))
    }

    fn arithmetic_of(&self, designed: &Designed) -> Arithmetic {
        B::arithmetic(designed)
    }

    fn typed(&self, designed: &Designed) -> &dyn Typed {
        B::other(designed).unwrap_or(self)
    }

    fn specialise(&self, kind: &dyn BlockKind, designed: &Designed, last: Option<&str>) -> Result<Program, Defect> {
        match B::arithmetic(designed) {
            Arithmetic::Double => program::<f64, B>(kind, designed, last),
            Arithmetic::Single => program::<f32, B>(kind, designed, last),
            Arithmetic::Wide => program::<Wide, B>(kind, designed, last),
        }
    }

    fn make(&self, kind: &dyn BlockKind, designed: &Designed) -> Result<Block, Defect> {
        match B::arithmetic(designed) {
            Arithmetic::Double => block::<f64, B>(kind, designed),
            Arithmetic::Single => block::<f32, B>(kind, designed),
            Arithmetic::Wide => block::<Wide, B>(kind, designed),
        }
    }

    fn run(&self, designed: &Designed) -> Box<dyn Run> {
        match B::arithmetic(designed) {
            Arithmetic::Double => Box::new(Running::<f64, B>::start(coefficients::<f64, B>(designed))),
            Arithmetic::Single => Box::new(Running::<f32, B>::start(coefficients::<f32, B>(designed))),
            Arithmetic::Wide => Box::new(Running::<Wide, B>::start(coefficients::<Wide, B>(designed))),
        }
    }

    fn numbers(&self, designed: &Designed) -> Vec<Literal> {
        match B::arithmetic(designed) {
            Arithmetic::Double => leaves(&coefficients::<f64, B>(designed)),
            Arithmetic::Single => leaves(&coefficients::<f32, B>(designed)),
            Arithmetic::Wide => leaves(&coefficients::<Wide, B>(designed)),
        }
    }

    fn coefficient_paths(&self) -> Vec<String> {
        specialise::paths::<<B as Reference<f64>>::Coeffs>()
    }
}

/// The fields of a struct, or of the elements of an array; a scalar has none.
pub(super) fn fields(ty: &Ty) -> &'static [Field] {
    match ty {
        Ty::Struct { def } => def.fields,
        Ty::Array { element, .. } => fields(element),
        Ty::Bool | Ty::I32 | Ty::U32 | Ty::Usize | Ty::Real(_) | Ty::Enum { .. } => &[],
    }
}

/// The coefficients of a reference, rounded to its real type.
fn coefficients<R: Real, B: Design + Reference<R>>(designed: &Designed) -> <B as Reference<R>>::Coeffs {
    rounded(&B::design(designed), R::KIND)
}

/// The program after the pass of that name; with `None`, the output of the specialiser.
fn program<R: Real, B: Design + Reference<R>>(
    kind: &dyn BlockKind,
    designed: &Designed,
    last: Option<&str>,
) -> Result<Program, Defect> {
    let notes = kind.notes(designed).into_iter().collect();
    let specialised = specialise::block::<R, B>(&coefficients::<R, B>(designed), &notes);
    match last {
        None => Ok(specialised),
        Some(VERIFIED) => Ok(finished(kind, designed, specialised)?.0),
        last => pass::run(specialised, last),
    }
}

/// The program after the last pass, without branches that are never taken, and the ranges of its outputs.
fn finished(kind: &dyn BlockKind, designed: &Designed, specialised: Program) -> Result<(Program, Shown), Defect> {
    let program = pass::run(specialised, None)?;
    let shown = shown(kind, designed, &program);
    Ok((ranges::decide(program, &shown.decided)?, shown))
}

/// Specialises one block and records its run.
fn block<R: Real, B: Design + Reference<R>>(kind: &dyn BlockKind, designed: &Designed) -> Result<Block, Defect> {
    let coeffs = coefficients::<R, B>(designed);
    let notes = kind.notes(designed).into_iter().collect();
    let specialised = specialise::block::<R, B>(&coeffs, &notes);
    let structure = structure::of(&specialised);
    let state_paths: Vec<String> = specialised.state.iter().map(|variable| variable.path.clone()).collect();
    let (program, shown) = finished(kind, designed, specialised)?;
    shown.refuse(program.block)?;
    let for_axis = legalise::for_axis(&program);
    let certificate = kind.certificate(designed, &program)?;
    let wanted = Wanted {
        ranges: kind.ranges(designed),
        start: kind.start_cycles(designed),
        drill: kind.drill(designed),
        cycle_time_ns: designed.axis.cycle_time_ns,
    };
    let exercise = Arc::new(Exercise::of::<R, B>(&coeffs, (&program, &for_axis), &state_paths, &wanted));
    let self_test = SelfTest::record(&exercise, &mut Running::<R, B>::start(coeffs));
    let trial = Trial::of(&exercise);
    let numbers = coefficients::<R, B>(designed);
    let start = || Box::new(Running::<R, B>::start(numbers)) as Box<dyn Run>;
    let answers = exercise::recording(trial.clone(), &program, &state_paths, start);
    let purpose = kind.purpose(designed);
    Ok(Block { program, for_axis, purpose, notes, exercise, self_test, trial, answers, certificate, shown, structure })
}

/// The ranges of the outputs of a program.
fn shown(kind: &dyn BlockKind, designed: &Designed, program: &Program) -> Shown {
    // If nothing adds a velocity, the limit is 0.
    let limit = kind.limit(designed).and_then(|figure| arithmetic::wide(figure.value)).unwrap_or(0.0);
    ranges::run(program, &["v_add", "v_add_calculated", "v_excite"].map(|path| (path, limit)))
}
