//! The products of a block's folder for any type of its reference: verified program, self-test, recorded run.

use super::block::Block;
use super::designed::Designed;
use super::kind::{BlockKind, Design, Typed};
use crate::design::rounding::rounded;
use crate::exercise::runner::{self, Runner};
use crate::exercise::{self, Exercise, Run, Running, SelfTest, Start, Trial, Wanted};
use compiler::legalise;
use compiler::pass::{self, Defect};
use compiler::ranges::{self, Shown};
use compiler::{arithmetic, leaves, program::Program, specialise, structure};
use portable::{Block as Reference, Field, Literal, Portable, Real, RealKind, Ty};
use std::collections::BTreeMap;
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

    fn computes_in(&self, designed: &Designed) -> RealKind {
        match designed.axis.real {
            RealKind::F64 => RealKind::F64,
            RealKind::F32 => B::Single::KIND,
        }
    }

    fn typed(&self, designed: &Designed) -> &dyn Typed {
        B::other(designed).unwrap_or(self)
    }

    fn specialise(&self, kind: &dyn BlockKind, designed: &Designed, last: Option<&str>) -> Result<Program, Defect> {
        match designed.axis.real {
            RealKind::F64 => program::<f64, B>(kind, designed, last),
            RealKind::F32 => program::<B::Single, B>(kind, designed, last),
        }
    }

    fn make(&self, kind: &dyn BlockKind, designed: &Designed) -> Result<Block, Defect> {
        match designed.axis.real {
            RealKind::F64 => block::<f64, B>(kind, designed),
            RealKind::F32 => block::<B::Single, B>(kind, designed),
        }
    }

    fn run(&self, designed: &Designed) -> Box<dyn Run> {
        match designed.axis.real {
            RealKind::F64 => Box::new(Running::<f64, B>::start(coefficients::<f64, B>(designed))),
            RealKind::F32 => Box::new(Running::<B::Single, B>::start(coefficients::<B::Single, B>(designed))),
        }
    }

    fn numbers(&self, designed: &Designed) -> Vec<Literal> {
        match designed.axis.real {
            RealKind::F64 => leaves(&coefficients::<f64, B>(designed)),
            RealKind::F32 => leaves(&coefficients::<B::Single, B>(designed)),
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
    let [coeffs, again] = [(); 2].map(|()| coefficients::<R, B>(designed));
    let notes = kind.notes(designed).into_iter().collect();
    let specialised = specialise::block::<R, B>(&coeffs, &notes);
    let usual = Exercise::usual::<R, B>(&coeffs);
    let later: Start = Box::new(|| Box::new(Running::<R, B>::start(again)));
    recorded::<R>((kind, designed), specialised, notes, usual, &mut Running::<R, B>::start(coeffs), later)
}

/// A specialised block with its recorded run. `usual`: the inputs with which it does everything it can; `reference` and
/// `later`: its reference before the first cycle.
fn recorded<R: Real>(
    (kind, designed): (&dyn BlockKind, &Designed),
    specialised: Program,
    notes: BTreeMap<String, String>,
    usual: Vec<Literal>,
    reference: &mut dyn Run,
    later: Start,
) -> Result<Block, Defect> {
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
    let exercise = Arc::new(Exercise::of::<R>(usual, (&program, &for_axis), &state_paths, &wanted));
    let self_test = SelfTest::record(&exercise, reference);
    let trial = Trial::of(&exercise);
    let answers = exercise::recording(trial.clone(), &program, &state_paths, later);
    let purpose = kind.purpose(designed);
    Ok(Block { program, for_axis, purpose, notes, exercise, self_test, trial, answers, certificate, shown, structure })
}

/// The ranges of the outputs of a program.
fn shown(kind: &dyn BlockKind, designed: &Designed, program: &Program) -> Shown {
    // If nothing adds a velocity, the limit is 0.
    let limit = kind.limit(designed).and_then(|figure| arithmetic::wide(figure.value)).unwrap_or(0.0);
    ranges::run(program, &["v_add", "v_add_calculated", "v_excite"].map(|path| (path, limit)))
}
