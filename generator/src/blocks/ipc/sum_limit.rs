//! The largest sum of stages that is not a fault, from the design alone. Nothing is measured here.

use super::certificate::chain::Chain;
use super::certificate::norm;
use super::certificate::section::Section;
use super::stage::StageDesign;
use crate::axis::Ipc;
use crate::design::rounding::sample_limit;
use portable::Extreme;
use portable::RealKind;
use reference::stage::{DirectSource, Mode};

/// What a sum may be above the largest one of an axis that stays within its largest velocity: room for an axis that overshoots.
const ROOM: f64 = 2.0;
/// Where no bound is certain, this times a sample in range: no sum of samples comes near it.
const WITHOUT_BOUND: f64 = 1e6;

/// The sum beyond which a state has been overwritten, or samples are no velocities of this axis:
///
/// ```text
/// sum_limit = 2 max(limit, v_max sum |h|)
/// ```
///
/// with the largest velocity v_max (P-AXIS-00212) and the impulse response h from a velocity to the sum. No sequence of samples within
/// +-2 v_max leads there. The sections are those of single precision: in double precision they do the same by other coefficients.
pub(crate) fn sum_limit<'s>(ipc: &Ipc, real: RealKind, stages: impl Iterator<Item = &'s StageDesign>) -> f64 {
    let chains: Vec<Chain> = stages.map(chain).collect();
    let sum = norm::bounds(&chains, RealKind::F64).v_sum * ipc.v_max;
    (ROOM * sum.larger(ipc.limit())).smaller(WITHOUT_BOUND * sample_limit(real))
}

fn chain(stage: &StageDesign) -> Chain {
    // Stages that look at the same velocity are added up before their magnitudes are.
    let input = match (stage.coeffs.mode, stage.coeffs.direct_source) {
        (Mode::SetPoint, _) => 0,
        (Mode::Direct, DirectSource::Direct) => 2,
        _ => 1,
    };
    let section = stage.section.iter().map(|section| Section::Trapezoidal(section.trapezoidal)).collect();
    Chain { input, section, gain: stage.coeffs.gain }
}
