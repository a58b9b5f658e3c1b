//! One filter of a stage: which kind, how many sections, their coefficients.

use super::band::band;
use super::{allpass, bandpass};
use crate::axis::Filter;
use portable::Real;
use reference::filter::{Coeffs, Type};

/// Coefficients of a filter (P-AXIS-00849) at the cycle time [s]; what its kind does not use is 0.
#[must_use]
pub fn coefficients<R: Real>(filter: &Filter, cycle_time: f64) -> Coeffs<R> {
    let mut coeffs = Coeffs::default();
    match *filter {
        Filter::NoFilter => {}
        Filter::Bandpass { prototype, order, f0, q_factor } => {
            coeffs.kind = Type::Bandpass;
            coeffs.order = order;
            let sections = bandpass::sections(prototype, order, &band(f0, q_factor, cycle_time));
            for (place, section) in coeffs.bandpass.iter_mut().zip(&sections) {
                *place = bandpass::coefficients(section);
            }
        }
        Filter::Allpass { f0, q_factor } => {
            coeffs.kind = Type::Allpass;
            coeffs.allpass = allpass::coefficients(&band(f0, q_factor, cycle_time));
        }
    }
    coeffs
}

/// Centre frequency [Hz] of a filter (P-AXIS-00751).
#[must_use]
pub fn f0(filter: &Filter) -> Option<f64> {
    match *filter {
        Filter::NoFilter => None,
        Filter::Bandpass { f0, .. } | Filter::Allpass { f0, .. } => Some(f0),
    }
}
