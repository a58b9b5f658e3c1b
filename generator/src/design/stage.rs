//! One stage: its source, the simulated oscillation, its filters, its gain.

use super::band::warped;
use super::{filter, oscillation};
use crate::axis::{self, Stage};
use portable::Real;
use reference::stage::{Coeffs, DirectSource, Mode};

/// Coefficients of a stage at the cycle time [s]; those of an inactive one are all 0.
///
/// gain = -weight = -min(num / denom, 7): negative in all modes, because the stage moves the motor against the vibration
/// (P-AXIS-00753, P-AXIS-00754, P-AXIS-00755). The simulated oscillation has the centre of the stage's first band-pass.
#[must_use]
pub fn coefficients<R: Real>(stage: Option<&Stage>, cycle_time: f64) -> Coeffs<R> {
    let mut coeffs = Coeffs::default();
    if let Some(stage) = stage {
        (coeffs.mode, coeffs.direct_source) = source(stage.mode);
        if let Some(damping) = osc_damping(stage.mode) {
            coeffs.oscillation = oscillation::coefficients(warped(stage.f0(), cycle_time), damping);
        }
        for (place, of) in coeffs.filter.iter_mut().zip(&stage.filter) {
            *place = filter::coefficients(of, cycle_time);
        }
        coeffs.gain = R::lit(-stage.weight());
    }
    coeffs
}

/// Damping ratio of the simulated oscillation (P-AXIS-00850) where the mode has one.
#[must_use]
pub fn osc_damping(mode: axis::Mode) -> Option<f64> {
    match mode {
        axis::Mode::Direct { .. } => None,
        axis::Mode::Indirect { osc_damping } | axis::Mode::SetPoint { osc_damping } => Some(osc_damping),
    }
}

fn source(mode: axis::Mode) -> (Mode, DirectSource) {
    match mode {
        axis::Mode::Direct { source: axis::DirectSource::Motor } => (Mode::Direct, DirectSource::Motor),
        axis::Mode::Direct { source: axis::DirectSource::Direct } => (Mode::Direct, DirectSource::Direct),
        axis::Mode::Indirect { .. } => (Mode::Indirect, DirectSource::default()),
        axis::Mode::SetPoint { .. } => (Mode::SetPoint, DirectSource::default()),
    }
}
