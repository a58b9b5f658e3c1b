//! The effect of stages at each other's f0, their group delay, and the all-pass that compensates the lag of a loop.

use crate::axis::{Filter, Mode};
use crate::blocks::Designed;
use crate::blocks::ipc::closed_loop::{self, Known};
use crate::blocks::ipc::filter as kinds;
use crate::blocks::ipc::stage::StageDesign;
use crate::design::band::{band, warped};
use crate::design::response::{self, magnitude};
use reference::design::inputs::LARGEST_SHARE;
use stability::Loop;
use std::f64::consts::PI;

/// Quality factor of the proposed all-pass: flat enough not to narrow the stage, steep enough to reach most leads.
const Q_FACTOR: f64 = 2.0;
/// The lowest f0, as a part of the stage's f0. The phase of a lower one at the stage's f0 is negligible.
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

/// The gain of another stage at the f0 of a stage, relative to the gain of the stage there.
pub(super) fn interaction(of: &StageDesign, other: &StageDesign) -> f64 {
    let t = warped(of.stage.f0(), of.cycle_time);
    let [own, others] = [of, other].map(|design| magnitude(response::of_stage(&design.coeffs, t)));
    others / own
}

/// The largest calm weight of a stage with a drive, and |S| at its f0 with it; `None` if no stage closes a loop.
pub(super) fn at_best(designed: &Designed, of: &StageDesign, drive: &Known) -> Option<[f64; 2]> {
    let points = closed_loop::points(designed, std::slice::from_ref(drive), designed.axis.drive.position_gain)?;
    let closed = Loop::new(&points, drive.drive());
    let [_, calm] = closed.largest_weights(of.index);
    let mut weight =
        designed.stage.each_ref().map(|design| design.as_ref().map_or(0.0, |design| design.stage.weight()));
    weight[of.index] = calm;
    let open = closed.with(weight).at_frequency(of.stage.f0()).open;
    Some([calm, 1.0 / (1.0 + open).norm()])
}

/// Quality factor and f0 [Hz] of the all-pass that gives a stage `lead` degrees of lead at its f0. `None` if the stage
/// already has an all-pass or filters the command (SET_POINT), or if no f0 in the range reaches the lead.
///
/// The phase of an all-pass falls from 0 to -360 degrees; a lead is a lag reduced by 360 degrees. The phase at the stage's
/// f0 rises with the f0 of the all-pass.
pub(super) fn allpass(of: &StageDesign, lead: f64) -> Option<[f64; 2]> {
    let has_one = of.stage.filter.iter().any(|filter| matches!(filter, Filter::Allpass { .. }));
    let filters_command = matches!(of.stage.mode, Mode::SetPoint { .. });
    if has_one || filters_command {
        return None;
    }
    let wanted = (lead % 360.0) - 360.0;
    let t = warped(of.stage.f0(), of.cycle_time);
    let phase = |f0: f64| {
        let filter = Filter::Allpass { f0, q_factor: Q_FACTOR };
        kinds::of(&filter)?.phase(&band(f0, Q_FACTOR, of.cycle_time), t)
    };
    let (mut low, mut high) = (of.stage.f0() * LOWEST, LARGEST_SHARE / of.cycle_time);
    if phase(low)? > wanted || phase(high)? < wanted {
        return None;
    }
    for _ in 0..STEPS {
        let middle = (low * high).sqrt();
        if phase(middle)? < wanted { low = middle } else { high = middle }
    }
    Some([Q_FACTOR, low])
}
