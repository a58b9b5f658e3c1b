//! From a designed axis to one of its blocks: specialise, the passes, the self-test, the recorded run. No target here.

use super::part::Part;
use crate::blocks::designed::Designed;
use crate::design::rounding::rounded;
use crate::self_test::{self, SelfTest};
use crate::vector::{self, Recording};
use compiler::pass::{self, Defect};
use compiler::program::Program;
use compiler::specialise;
use portable::{Block as Reference, Real};
use std::collections::BTreeMap;

/// A block of one axis, ready to be printed.
#[derive(Clone, Debug)]
pub struct Block {
    /// the verified program
    pub program: Program,
    /// what the coefficients under a path mean, for a reviewer
    pub notes: BTreeMap<String, String>,
    /// what a self-test does and expects
    pub self_test: SelfTest,
    /// a recorded run
    pub vector: Recording,
    /// what is certain of its range, and its measured response, in words
    pub certificate: Vec<String>,
}

/// The program after the pass of that name; none: as the specialiser gives it.
pub(crate) fn program<R: Real, P: Part + Reference<R>>(
    designed: &Designed,
    last: Option<&str>,
) -> Result<Program, Defect> {
    let notes = P::notes(designed).into_iter().collect();
    let specialised = specialise::block::<R, P>(&rounded(&P::coefficients(designed), R::KIND), &notes);
    match last {
        Some(last) => pass::run(specialised, Some(last)),
        None => Ok(specialised),
    }
}

/// Specialises one block and records what it does.
pub(crate) fn block<R: Real, P: Part + Reference<R>>(designed: &Designed) -> Result<Block, Defect> {
    let coeffs: <P as Reference<R>>::Coeffs = rounded(&P::coefficients(designed), R::KIND);
    let ranges = P::ranges(designed);
    let notes = P::notes(designed).into_iter().collect();
    let specialised = specialise::block::<R, P>(&coeffs, &notes);
    let paths: Vec<String> = specialised.state.iter().map(|variable| variable.path.clone()).collect();
    let program = pass::run(specialised, None)?;
    let self_test = self_test::record::<R, P>(&coeffs, &program, &paths, ranges);
    let certificate = P::certificate(designed, &program);
    let vector = vector::recording::<R, P>(coeffs, &program, ranges);
    Ok(Block { program, notes, self_test, vector, certificate })
}
