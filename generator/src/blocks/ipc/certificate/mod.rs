//! The proven properties of a compiled block: the largest values inside it, and its response compared with the designed one.
//!
//! Nothing here decides anything. No coefficient is taken from the design, except to compare with it.

pub mod chain;
mod free;
mod lines;
pub mod noise;
pub mod norm;
pub mod probe;
mod response;
pub mod section;
mod widened;

use super::filter::{self, FilterDesign};
use super::stage::StageDesign;
use crate::design::band::warped;
use crate::design::rounding::{largest, sample_limit};
use crate::number::digits;
use crate::{axis::Axis, blocks::designed::Designed};
use compiler::pass::Defect;
use compiler::program::Program;
pub use lines::{figure, lines};
use portable::Extreme;
use portable::RealKind;
pub(crate) use response::designed;
use response::{Band, Point};

/// The proven properties of a block.
pub struct Certificate {
    pub real: RealKind,
    /// unit of the velocities
    pub unit: &'static str,
    /// largest velocity of the axis (P-AXIS-00212)
    pub v_max: f64,
    /// largest |v_add| (P-AXIS-00757)
    pub limit: f64,
    /// for inputs within +-1: every bound is proportional to the inputs
    pub bound: norm::Bound,
    /// the response of each stage, at centre and edges of each filter; empty if a limit of 0 mutes the block, since nothing
    /// can be measured there
    pub response: Vec<Band>,
    /// signal-to-noise ratio [dB] of a stage, by its index, in single precision
    pub noise: Vec<(usize, f64)>,
}

/// Measures the block `ipc` of an axis by single steps of its program and computes its bounds.
///
/// The bounds hold in the block's own arithmetic, including its roundings: for every sequence of samples within the range,
/// and for every state that such a sequence leads to.
///
/// # Panics
/// If the program is not the block `ipc` of this axis.
pub fn certify(designed: &Designed, program: &Program) -> Certificate {
    let Axis { real, ipc, .. } = &designed.axis;
    let stages: Vec<&StageDesign> = designed.stage.iter().flatten().collect();
    let chains = chain::measure(program, &stages, ipc.limit());
    let measured = stages.iter().zip(&chains).filter(|_| ipc.limit() > 0.0);
    let response = measured.flat_map(|(stage, chain)| response::bands(stage, chain, *real)).collect();
    let noise = stages.iter().zip(&chains);
    let noise = noise.filter_map(|(stage, chain)| Some((stage.index, noise::of_chain(chain, stage)?))).collect();
    Certificate {
        real: *real,
        unit: designed.axis.control.velocity_unit(),
        v_max: ipc.v_max,
        limit: ipc.limit(),
        bound: norm::bounds(&chains, *real),
        response,
        noise,
    }
}

impl Certificate {
    /// The largest |measured - designed| / |designed| of the points that are shown; `None` if nothing was measured.
    pub fn deviation(&self) -> Option<f64> {
        let shown = self.response.iter().filter(|band| band.is_shown);
        shown.flat_map(|band| &band.points).map(Point::deviation).max_by(f64::total_cmp)
    }

    /// Rejects a block whose response differs from the designed one.
    ///
    /// # Errors
    /// The stage, its frequency, how far it deviates: a defect of the design, of the reference or of a pass.
    pub fn refuse(&self, designed: &Designed) -> Result<(), Defect> {
        for Band { stage, points, .. } in &self.response {
            let Some(design) = &designed.stage[*stage] else { continue };
            let allowed = largest_defect(design, self.real);
            for point in points {
                let found = point.defect();
                if found.is_nan() || found > allowed {
                    let at = digits(point.frequency);
                    let message = format!(
                        "stage[{stage}] at {at} Hz deviates by {found:.1e} from what was designed, by more than {allowed:.1e}"
                    );
                    return Err(Defect { pass: "certificate", message });
                }
            }
        }
        Ok(())
    }

    /// Whether every value inside the block stays finite for any sample in range.
    fn is_within_precision(&self) -> bool {
        // An intermediate value is a sum of up to three products of a state and a coefficient of up to 4; in a
        // trapezoidal section, whose C may be larger, each product is a sum of up to four states.
        self.bound.state.larger(self.bound.v_sum).larger(1.0) * sample_limit(self.real) * 8.0 <= largest(self.real)
    }
}

/// The largest deviation of a response apart from the rounding of coefficients to single precision: 1e-6. In double
/// precision it includes the rounding of coefficients, because biquads have 1 + a1 + a2 = 4 g^2: a centre moves by a part of
/// 2^-52 / g^2, and the phase at the edge of a band of quality Q by Q times that, in each of its sections.
pub fn largest_defect(design: &StageDesign, real: RealKind) -> f64 {
    let moved = |g: f64| match real {
        RealKind::F64 => 4.0 * f64::EPSILON / (g * g),
        RealKind::F32 => 0.0,
    };
    let of_filter = |of: &FilterDesign| {
        let [_, q_factor] = of.filter.f0_and_q().unwrap_or_default();
        filter::of(&of.filter).map_or(0.0, |kind| kind.order() as f64) * (1.0 + q_factor) * moved(of.band.omega0)
    };
    let filters: f64 = design.filter.iter().flatten().map(of_filter).sum();
    let g = warped(design.stage.f0(), design.cycle_time);
    let oscillation = design.stage.mode.osc_damping().map_or(0.0, |damping| moved(g) * (1.0 + 1.0 / damping) / g);
    1e-6 + filters + oscillation
}
