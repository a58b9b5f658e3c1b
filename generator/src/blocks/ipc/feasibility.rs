//! Errors that can occur although each parameter is in its range: sections that rounding makes unusable.

use super::stage::{Element, Section, StageDesign};
use crate::design::rounding::precision;
use crate::design::{band::frequency, response::at_dc_and_nyquist, trapezoidal::Trapezoidal};
use crate::{axis::Axis, blocks::designed::Designed, codes, parameters::Name, rules::effective::Effective};
use portable::RealKind;

/// Why a section would endanger the machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    pub element: Element,
    pub found: String,
    pub allowed: String,
    pub instead: String,
}

/// The largest relative difference between a section's designed centre frequency and that of its rounded coefficients. With
/// a quality factor of 20 it changes the phase by 2 degrees.
pub const MAX_CENTRE_ERROR: f64 = 1e-3;

/// Reports the sections that rounding makes unusable, at the parameter that each depends on.
pub(crate) fn validate(designed: &Designed, e: &mut Effective<'_>) {
    for Refusal { element, found, allowed, instead } in refusals(designed) {
        let stage = as_index(element.stage);
        let key = match &element.filter {
            None => e.source((Name::OscDamping, [stage, 0])),
            Some(place) => (Name::FilterF0, [stage, as_index(place.filter)]),
        };
        e.refuse(codes::ROUNDING, key, format!("{element}: {found}"), [Some(allowed), Some(instead)]);
    }
}

/// The sections whose coefficients, rounded to the axis's real type, are unstable, or whose centre is off by more than
/// [`MAX_CENTRE_ERROR`].
pub fn refusals(designed: &Designed) -> Vec<Refusal> {
    let Axis { real, .. } = designed.axis;
    let of_stage = |stage: &StageDesign| refusals_of(stage, real);
    designed.stage.iter().flatten().flat_map(of_stage).collect()
}

/// The refused sections of a stage.
pub fn refusals_of(stage: &StageDesign, real: RealKind) -> Vec<Refusal> {
    stage.section.iter().filter_map(|section| refusal(section, real, stage.cycle_time)).collect()
}

fn refusal(section: &Section, real: RealKind, cycle_time: f64) -> Option<Refusal> {
    let precision = precision(real);
    let (is_stable, centre) = realised(section, real);
    let [intended, realised] = [section.shape.g, centre].map(|t| frequency(t, cycle_time));
    let (found, allowed) = if !is_stable {
        let (coefficients, condition) = condition(section, real);
        (format!("unstable with its coefficients in {precision} precision: {coefficients}"), condition.to_owned())
    } else if (realised - intended).abs() > MAX_CENTRE_ERROR * intended {
        let found = format!(
            "centre frequency {intended:.4e} Hz is {realised:.4e} Hz with its coefficients in {precision} precision"
        );
        (found, format!("a difference of {} %", MAX_CENTRE_ERROR * 100.0))
    } else {
        return None;
    };
    // The simulated oscillation depends on its damping, a filter on its frequency.
    let damping = if section.element.filter.is_none() { "a larger osc_damping (P-AXIS-00850), " } else { "" };
    let double = if real == RealKind::F32 { "double precision, " } else { "" };
    let instead = format!("{damping}{double}a higher fg_f0 (P-AXIS-00751) or a longer cycle time");
    Some(Refusal { element: section.element.clone(), found, allowed, instead })
}

/// Whether a section is stable with its rounded coefficients, and its centre on the warped axis.
///
/// The biquad in double precision is stable if |a2| < 1 and |a1| < 1 + a2; its centre is g^2 = (1 + a1 + a2) / (1 - a1 +
/// a2). The trapezoidal section in single precision has the trace 2 - B - A C and the determinant 1 + A C - B: it is stable
/// if 0 < A C < B < 2, and its centre is g^2 = A C / (2 - B). The simulated oscillation has A = G H, B = G R, C = G2.
fn realised(section: &Section, real: RealKind) -> (bool, f64) {
    if real == RealKind::F32 {
        return (section.trapezoidal.is_stable(), section.trapezoidal.centre());
    }
    let [a1, a2] = section.denominator;
    let [dc, nyquist] = at_dc_and_nyquist(1.0, a1, a2);
    (a2 < 1.0 && dc > 0.0 && nyquist > 0.0, libm::sqrt(dc / nyquist))
}

/// The coefficients that decide on stability, and what makes them stable.
fn condition(section: &Section, real: RealKind) -> (String, &'static str) {
    let ([a1, a2], Trapezoidal { a, b, c, .. }) = (section.denominator, section.trapezoidal);
    match real {
        RealKind::F64 => (format!("a1 = {a1:e}, a2 = {a2:e}"), "|a2| < 1 and |a1| < 1 + a2"),
        RealKind::F32 => (format!("A = {a:e}, B = {b:e}, C = {c:e}"), "0 < A C < B < 2"),
    }
}

fn as_index(position: usize) -> u32 {
    u32::try_from(position).expect("feasibility: a few stages and filters")
}
