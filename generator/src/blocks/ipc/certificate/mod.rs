//! What a compiled block is certain to keep: the largest values inside it, and its response beside the designed one.
//!
//! ```text
//! probe     verified program -> what single steps do
//! widened   a program of single precision, to be measured in double precision
//! chain     single steps -> sections and gain of each stage
//! section   a section as it acts
//! free      a section left to itself: closed-form bounds
//! norm      chain -> largest |state| and largest |v_sum| for inputs within +-1
//! response  chain -> gain and phase; parameters -> the same by the formulas
//! noise     chain -> signal-to-noise ratio of single precision
//! lines     all of it in words
//! ```
//! Nothing here decides anything; no coefficient is taken from the design, only what it is compared with.

pub(crate) mod chain;
mod free;
mod lines;
pub(crate) mod noise;
pub(crate) mod norm;
pub(crate) mod probe;
mod response;
pub(crate) mod section;
mod widened;

use super::stage::StageDesign;
use crate::design::rounding::{largest, sample_limit};
use crate::{axis::Axis, blocks::designed::Designed};
use compiler::program::Program;
pub(crate) use lines::{figure, lines};
use portable::RealKind;
use response::Point;
pub(crate) use response::designed;

/// What is certain of a block.
pub(crate) struct Certificate {
    pub real: RealKind,
    /// largest velocity of the axis [um/s or 0.001 deg/s] (P-AXIS-00212)
    pub v_max: f64,
    /// largest |v_add|, in the same unit (P-AXIS-00757)
    pub limit: f64,
    /// for inputs within +-1: every bound is proportional to the inputs
    pub bound: norm::Bound,
    /// the response of a stage, by its index, at centre and edges of a band-pass; none where a limit of 0 mutes the block, since
    /// nothing can be measured there
    pub response: Vec<(usize, [Point; 3])>,
    /// signal-to-noise ratio [dB] of a stage, by its index, in single precision
    pub noise: Vec<(usize, f64)>,
}

/// Measures the block `ipc` of an axis by single steps of its program and computes its bounds.
///
/// The bounds hold in the block's own arithmetic: for every sequence of samples within the range, from every state that
/// such a sequence leads to, its roundings included.
///
/// # Panics
/// If the program is not the block `ipc` of this axis.
pub(crate) fn certify(designed: &Designed, program: &Program) -> Certificate {
    let Axis { real, ipc, .. } = &designed.axis;
    let stages: Vec<&StageDesign> = designed.stage.iter().flatten().collect();
    let chains = chain::measure(program, &stages, ipc.limit());
    let measured = stages.iter().zip(&chains).filter(|_| ipc.limit() > 0.0);
    let response = measured.flat_map(|(stage, chain)| response::bands(stage, chain)).collect();
    let noise = stages.iter().zip(&chains);
    let noise = noise.filter_map(|(stage, chain)| Some((stage.index, noise::of_chain(chain, stage)?))).collect();
    Certificate {
        real: *real,
        v_max: ipc.v_max,
        limit: ipc.limit(),
        bound: norm::bounds(&chains, *real),
        response,
        noise,
    }
}

impl Certificate {
    /// The largest |measured - designed| / |designed| of all points; none where nothing was measured.
    pub(crate) fn deviation(&self) -> Option<f64> {
        self.response.iter().flat_map(|(_, points)| points).map(Point::deviation).max_by(f64::total_cmp)
    }

    /// Whether no value inside the block overflows for any sample in range.
    fn is_within_precision(&self) -> bool {
        // An intermediate value is a sum of up to three products of a state and a coefficient of up to 4; in a trapezoidal section,
        // whose C may be larger, each product is a sum of up to four states.
        self.bound.state.max(self.bound.v_sum).max(1.0) * sample_limit(self.real) * 8.0 <= largest(self.real)
    }
}
