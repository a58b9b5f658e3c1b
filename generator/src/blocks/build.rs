//! From a designed axis to one of its blocks: specialise, the passes, the self-test, the recorded run. No target here.

use super::{designed::Designed, kind::Part};
use crate::design::rounding::rounded;
use crate::self_test::{self, SelfTest};
use crate::vector::{self, Recording};
use compiler::pass::{self, Defect};
use compiler::{program::Program, specialise};
use portable::{Block as Reference, Real};
use std::collections::BTreeMap;

/// A block of one axis, ready to be printed.
#[derive(Clone, Debug)]
pub struct Block {
    /// verified
    pub program: Program,
    /// what the coefficients under a path mean, for a reviewer
    pub(crate) notes: BTreeMap<String, String>,
    pub(crate) self_test: SelfTest,
    /// a recorded run
    pub vector: Recording,
    /// what is certain of its range, and its measured response, in words
    pub certificate: Vec<String>,
}

/// The program after the pass of that name; none: as the specialiser gives it.
pub(super) fn program<R: Real, P: Part + Reference<f64> + Reference<R>>(
    part: &P,
    designed: &Designed,
    last: Option<&str>,
) -> Result<Program, Defect> {
    let notes = part.notes(designed).into_iter().collect();
    let specialised = specialise::block::<R, P>(&rounded(&P::design(designed), R::KIND), &notes);
    if last.is_some() { pass::run(specialised, last) } else { Ok(specialised) }
}

/// Specialises one block and records what it does.
pub(super) fn block<R: Real, P: Part + Reference<f64> + Reference<R>>(
    part: &P,
    designed: &Designed,
) -> Result<Block, Defect> {
    let coeffs = || rounded(&P::design(designed), R::KIND);
    let ranges = part.ranges(designed);
    let notes = part.notes(designed).into_iter().collect();
    let specialised = specialise::block::<R, P>(&coeffs(), &notes);
    let paths: Vec<String> = specialised.state.iter().map(|variable| variable.path.clone()).collect();
    let program = pass::run(specialised, None)?;
    let self_test = self_test::record::<R, P>(coeffs(), &program, &paths, ranges);
    let certificate = part.certificate(designed, &program);
    let vector = vector::recording::<R, P>(coeffs(), &program, ranges);
    Ok(Block { program, notes, self_test, vector, certificate })
}
