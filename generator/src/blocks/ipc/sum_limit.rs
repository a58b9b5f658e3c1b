//! The largest sum of stages that is not a fault, derived from the design only. Nothing is measured here.

use super::certificate::chain::Chain;
use super::certificate::norm;
use super::certificate::section::Section;
use super::stage::StageDesign;
use crate::axis::Ipc;
use crate::design::rounding::sample_limit;
use portable::Extreme;
use portable::RealKind;
use reference::stage::{DirectSource, Mode};

/// The factor above the largest sum of an axis within its largest velocity: reserve for overshoot.
const ROOM: f64 = 2.0;
/// If no bound is proven, the limit is this factor times a sample in range: no sum of samples comes near it.
const WITHOUT_BOUND: f64 = 1e6;

/// The limit above which the memory was corrupted, or an input is far above v_max:
///
/// ```text
/// sum_limit = 2 max(limit, v_max sum |h|)
/// ```
///
/// with the largest velocity v_max (P-AXIS-00212) and the impulse response h from a velocity to the sum. No sequence of
/// samples within +-2 v_max exceeds it. The sections are those of single precision; in double precision the response is the
/// same.
pub(crate) fn sum_limit<'s>(ipc: &Ipc, real: RealKind, stages: impl Iterator<Item = &'s StageDesign>) -> f64 {
    let chains: Vec<Chain> = stages.map(chain).collect();
    let sum = norm::bounds(&chains, RealKind::F64).v_sum * ipc.v_max;
    (ROOM * sum.larger(ipc.limit())).smaller(WITHOUT_BOUND * sample_limit(real))
}

fn chain(stage: &StageDesign) -> Chain {
    // Responses of stages with the same input velocity are added before their magnitudes are summed.
    let input = match (stage.coeffs.mode, stage.coeffs.direct_source) {
        (Mode::SetPoint, _) => 0,
        (Mode::Direct, DirectSource::Direct) => 2,
        _ => 1,
    };
    let section = stage.section.iter().map(|section| Section::Trapezoidal(section.trapezoidal)).collect();
    Chain { input, section, gain: stage.coeffs.gain }
}
