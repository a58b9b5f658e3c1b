//! What stages do at each other's f0, how long they delay, and the all-pass that gives back what a loop lags.

use crate::axis::{Filter, Mode};
use crate::blocks::ipc::filter as kinds;
use crate::blocks::ipc::stage::StageDesign;
use crate::design::band::{band, warped};
use crate::design::response::{self, magnitude};
use std::f64::consts::PI;

/// Quality factor of the all-pass that is proposed: flat enough not to narrow the stage, steep enough to reach most leads.
const Q_FACTOR: f64 = 2.0;
/// The highest f0 of a filter, as a part of the sampling frequency.
const HIGHEST: f64 = 0.45;
/// The lowest one, as a part of the stage's f0: lower ones turn by nothing that anybody needs.
const LOWEST: f64 = 1e-3;
/// Halvings of the interval of the search.
const STEPS: u32 = 60;
/// Step of the difference quotient of the phase, as a part of f0.
const STEP: f64 = 1e-4;

/// The delay of the group about f0 [s]: -d phase/d omega of the stage.
pub(super) fn group_delay(of: &StageDesign) -> f64 {
    let f0 = of.stage.f0();
    let at = |part: f64| response::of_stage(&of.coeffs, warped(f0 * part, of.cycle_time));
    let turn = at(1.0 + STEP) * at(1.0 - STEP).conj();
    -libm::atan2(turn.im, turn.re) / (2.0 * PI * f0 * 2.0 * STEP)
}

/// What another stage adds at the f0 of a stage, as a part of what the stage adds there.
pub(super) fn interaction(of: &StageDesign, other: &StageDesign) -> f64 {
    let t = warped(of.stage.f0(), of.cycle_time);
    let [own, others] = [of, other].map(|design| magnitude(response::of_stage(&design.coeffs, t)));
    others / own
}

/// Quality factor and f0 [Hz] of the all-pass that turns a stage by that many degrees of lead at its f0; none: it has an all-pass, or none
/// reaches it.
///
/// An all-pass turns from 0 to -360 degrees, and a lead is a lag of 360 degrees less. Its phase at the stage's f0 rises with its own f0.
pub(super) fn allpass(of: &StageDesign, lead: f64) -> Option<[f64; 2]> {
    let has_one = of.stage.filter.iter().any(|filter| matches!(filter, Filter::Allpass { .. }));
    let is_open_loop = matches!(of.stage.mode, Mode::SetPoint { .. });
    if has_one || is_open_loop {
        return None;
    }
    let wanted = (lead % 360.0) - 360.0;
    let t = warped(of.stage.f0(), of.cycle_time);
    let phase = |f0: f64| {
        let filter = Filter::Allpass { f0, q_factor: Q_FACTOR };
        kinds::of(&filter)?.phase(&band(f0, Q_FACTOR, of.cycle_time), t)
    };
    let (mut low, mut high) = (of.stage.f0() * LOWEST, HIGHEST / of.cycle_time);
    if phase(low)? > wanted || phase(high)? < wanted {
        return None;
    }
    for _ in 0..STEPS {
        let middle = (low * high).sqrt();
        if phase(middle)? < wanted { low = middle } else { high = middle }
    }
    Some([Q_FACTOR, low])
}
