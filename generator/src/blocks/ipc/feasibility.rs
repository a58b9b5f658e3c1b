//! What must not run on a machine although each parameter is in its range: sections that rounding has spoilt.

use super::check::damping_given;
use super::design::{Element, Section};
use crate::blocks::designed::Designed;
use crate::codes;
use crate::design::band::frequency;
use crate::design::denominator::at_dc_and_nyquist;
use crate::design::rounding::in_precision;
use crate::diagnostics::Diagnostic;
use crate::parameters::Name;
use crate::rules::effective::Effective;
use portable::RealKind;

/// Why a section would endanger the machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// which section
    pub element: Element,
    /// what is wrong
    pub found: String,
    /// what would be allowed
    pub allowed: String,
    /// what to write instead
    pub instead: String,
}

/// The largest relative difference between a section's centre frequency as designed and as its rounded coefficients
/// realise it. At a section's quality factor of 20 it turns the phase by 2 degrees.
pub(crate) const MAX_CENTRE_ERROR: f64 = 1e-3;

/// Says which sections their rounding has spoilt, at the parameter that each depends on.
pub(crate) fn validate(designed: &Designed, e: &mut Effective<'_>) {
    for Refusal { element, found, allowed, instead } in refusals(designed) {
        let stage = as_index(element.stage());
        let key = match element.filter() {
            None => (damping_given(e, stage), [stage, 0]),
            Some(filter) => (Name::FilterF0, [stage, as_index(filter)]),
        };
        let diagnostic = Diagnostic::error(codes::ROUNDING, e.place_of(key), format!("{element}: {found}"));
        e.report.push(diagnostic.allowed(allowed).instead(instead));
    }
}

/// The sections whose coefficients, rounded to the axis's real type, are unstable, |a2| >= 1 or |a1| >= 1 + a2, or whose centre is
/// off by more than [`MAX_CENTRE_ERROR`].
#[must_use]
pub fn refusals(designed: &Designed) -> Vec<Refusal> {
    let stages = designed.ipc.stage.iter().flatten();
    stages.flat_map(|stage| &stage.section).filter_map(|section| refusal(section, designed)).collect()
}

fn refusal(section: &Section, designed: &Designed) -> Option<Refusal> {
    let (real, cycle_time) = (designed.axis.real, designed.axis.cycle_time());
    let [a1, a2] = [section.a1, section.a2].map(|coefficient| in_precision(coefficient, real));
    let precision = match real {
        RealKind::F64 => "double",
        RealKind::F32 => "single",
    };
    let [dc, nyquist] = at_dc_and_nyquist(1.0, a1, a2);
    let element = section.element;
    if !(a2 < 1.0 && dc > 0.0 && nyquist > 0.0) {
        return Some(Refusal {
            element,
            found: format!("unstable with its coefficients in {precision} precision: a1 = {a1:e}, a2 = {a2:e}"),
            allowed: "|a2| < 1 and |a1| < 1 + a2".to_owned(),
            instead: instead_of(element, real),
        });
    }
    let intended = frequency(section.g, cycle_time);
    let realised = frequency(libm::sqrt(dc / nyquist), cycle_time);
    ((realised - intended).abs() > MAX_CENTRE_ERROR * intended).then(|| Refusal {
        element,
        found: format!(
            "centre frequency {intended:.4e} Hz is {realised:.4e} Hz with its coefficients in {precision} precision"
        ),
        allowed: format!("a difference of {} %", MAX_CENTRE_ERROR * 100.0),
        instead: instead_of(element, real),
    })
}

/// The simulated oscillation depends on its damping, a filter on its frequency.
fn instead_of(element: Element, real: RealKind) -> String {
    let damping = if element.filter().is_none() { "a larger osc_damping (P-AXIS-00850), " } else { "" };
    let precision = match real {
        RealKind::F64 => "",
        RealKind::F32 => "double precision, ",
    };
    format!("{damping}{precision}a higher fg_f0 (P-AXIS-00751) or a longer cycle time")
}

fn as_index(position: usize) -> u32 {
    u32::try_from(position).expect("feasibility: a few stages and filters")
}
