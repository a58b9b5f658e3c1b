//! From an axis to its blocks: design, specialise, the passes, the self-test. No target here.

use crate::axis::Axis;
use crate::pass::{self, Defect};
use crate::program::Program;
use crate::self_test::{self, SelfTest};
use crate::vector::{self, Vector};
use crate::{certificate, design, specialise};
use portable::{Literal, Portable, Real, RealKind};
use reference::{Block as Reference, ipc::Ipc};
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
    pub vector: Vector,
    /// what is certain of its range, and its measured response, in words
    pub certificate: Vec<String>,
}

/// The names of an axis's blocks, in the order of [`blocks`].
#[must_use]
pub fn names(_: &Axis) -> Vec<&'static str> {
    vec![<Ipc as Reference<f64>>::NAME]
}

/// The blocks of an axis.
///
/// # Errors
/// A defect of a block or of a pass.
pub fn blocks(axis: &Axis) -> Result<Vec<Block>, Defect> {
    match axis.real {
        RealKind::F64 => blocks_as::<f64>(axis),
        RealKind::F32 => blocks_as::<f32>(axis),
    }
}

/// The programs of an axis after the pass of that name; none: as the specialiser gives them.
///
/// # Errors
/// A defect of a block or of a pass.
pub fn programs(axis: &Axis, last: Option<&str>) -> Result<Vec<Program>, Defect> {
    let notes = design::notes(axis).into_iter().collect();
    let specialised = match axis.real {
        RealKind::F64 => specialise::block::<f64, Ipc>(&design::ipc(axis), &notes),
        RealKind::F32 => specialise::block::<f32, Ipc>(&design::ipc(axis), &notes),
    };
    Ok(vec![match last {
        Some(last) => pass::run(specialised, Some(last))?,
        None => specialised,
    }])
}

fn blocks_as<R: Real>(axis: &Axis) -> Result<Vec<Block>, Defect> {
    let notes = design::notes(axis).into_iter().collect();
    let (limit, v_max) = (design::ipc::limit(&axis.ipc), axis.ipc.v_max);
    let unlimited = if limit > 0.0 { limit / 16.0 } else { v_max };
    let mut ipc = block::<R, Ipc>(&design::ipc(axis), notes, [unlimited, v_max])?;
    ipc.certificate = certificate::lines(&certificate::certify(axis, &ipc));
    Ok(vec![ipc])
}

/// Specialises one block. `ranges` are those of its real inputs: where no limit acts, and the largest in operation.
fn block<R: Real, B: Reference<R>>(
    coeffs: &B::Coeffs,
    notes: BTreeMap<String, String>,
    ranges: [f64; 2],
) -> Result<Block, Defect> {
    let specialised = specialise::block::<R, B>(coeffs, &notes);
    let paths: Vec<String> = specialised.state.iter().map(|variable| variable.path.clone()).collect();
    let program = pass::run(specialised, None)?;
    let self_test = self_test::record::<R, B>(coeffs, &program, &paths, ranges);
    let vector = vector::record::<R, B>(coeffs, &program, ranges);
    Ok(Block { program, notes, self_test, vector, certificate: Vec::new() })
}

/// The scalar that a real is.
pub fn leaf<R: Real>(value: R) -> Literal {
    leaves(&value)[0]
}

/// The scalars of a value, in the order of its type.
pub fn leaves<T: Portable>(value: &T) -> Vec<Literal> {
    let mut leaves = Vec::new();
    value.visit(&mut |literal| leaves.push(literal));
    leaves
}
