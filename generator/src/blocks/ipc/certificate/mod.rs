//! What a compiled block is certain to keep: the largest values inside it, and its response beside the designed one.
//!
//! ```text
//! probe     verified program -> what single steps do
//! chain     single steps -> sections and gain of each stage, as they act
//! free      a section left to itself: closed-form bounds
//! norm      chain -> largest |state| and largest |v_sum| for inputs within +-1
//! response  chain -> gain and phase; parameters -> the same by the formulas
//! lines     all of it in words
//! ```
//! Nothing here decides anything; no coefficient is taken from the design, only what it is compared with.

mod chain;
mod free;
mod lines;
mod norm;
mod probe;
mod response;

pub use lines::lines;
pub use norm::Bound;
pub use response::{Band, Point};

use super::design::Section;
use crate::blocks::designed::Designed;
use crate::design::rounding::{largest, sample_limit};
use compiler::program::Program;
use portable::RealKind;

/// What is certain of a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// the real type of the block
    pub real: RealKind,
    /// largest velocity of the axis [um/s or 0.001 deg/s] (P-AXIS-00212)
    pub v_max: f64,
    /// largest |v_add|, in the same unit (P-AXIS-00757)
    pub limit: f64,
    /// largest magnitude of a sample in range, in the same unit
    pub sample_limit: f64,
    /// of the whole block, for inputs within +-1: every bound is proportional to the inputs
    pub bound: Bound,
    /// the active stages
    pub stage: Vec<StageCertificate>,
    /// the largest relative difference between a single step of the block and what its sections predict for it
    pub chain_error: f64,
}

/// What is certain of a stage.
#[derive(Clone, Debug, PartialEq)]
pub struct StageCertificate {
    /// its index
    pub index: usize,
    /// of this stage alone, for inputs within +-1
    pub bound: Bound,
    /// its response at the band-passes; empty where a limit of 0 mutes the block, since nothing can be measured there
    pub band: Vec<Band>,
}

/// Measures the block `ipc` of an axis by single steps of its program and computes its bounds.
///
/// The bounds hold in the block's own arithmetic: for every sequence of samples within the range, from every state that
/// such a sequence leads to, its roundings included.
///
/// # Panics
/// If the program is not the block `ipc` of this axis.
#[must_use]
pub fn certify(designed: &Designed, program: &Program) -> Certificate {
    let axis = &designed.axis;
    let limit = axis.ipc.limit();
    let stages: Vec<&[Section]> = designed
        .ipc
        .stage
        .iter()
        .map(|stage| stage.as_ref().map_or(&[][..], |stage| stage.section.as_slice()))
        .collect();
    let (chains, chain_error) = chain::measure(program, &stages, limit);
    let (bound, of_stages) = norm::bounds(&chains, axis.real);
    let stage = chains.iter().zip(of_stages).map(|(chain, bound)| {
        let band = if limit > 0.0 { response::bands(designed, chain) } else { Vec::new() };
        StageCertificate { index: chain.stage, bound, band }
    });
    Certificate {
        real: axis.real,
        v_max: axis.ipc.v_max,
        limit,
        sample_limit: sample_limit(axis.real),
        bound,
        stage: stage.collect(),
        chain_error,
    }
}

impl Certificate {
    /// The largest |measured - designed| / |designed| of all points; none where nothing was measured.
    #[must_use]
    pub fn deviation(&self) -> Option<f64> {
        let points = self.stage.iter().flat_map(|stage| &stage.band).flat_map(|band| &band.point);
        points.map(Point::deviation).max_by(f64::total_cmp)
    }

    /// Whether no value inside the block overflows for any sample in range.
    #[must_use]
    pub(crate) fn is_within_precision(&self) -> bool {
        // An intermediate value is a sum of up to three products of a state and a coefficient of up to 2.
        self.bound.state.max(self.bound.v_sum).max(1.0) * self.sample_limit * 8.0 <= largest(self.real)
    }
}
