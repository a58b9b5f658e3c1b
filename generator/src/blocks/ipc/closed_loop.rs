//! The loop that the stages of an axis close through the velocity of the motor: the controller of the crate `stability`, and the drives that
//! it is judged with.

use super::stage::StageDesign;
use crate::axis::{DirectSource, DriveModel, Filter, Mode};
use crate::blocks::designed::Designed;
use crate::design::response;
use crate::number::significant;
use reference::stage::Coeffs;
use stability::{Band, Complex64, Controller, Drive, Points, STAGES};

/// Cycles of a usual drive: the cycle that the command needs, and half a cycle of its hold.
pub(crate) const USUAL_DELAY: f64 = 1.5;
/// Time constant of a usual drive with a slow velocity controller [s].
pub(crate) const USUAL_TIME_CONSTANT: f64 = 0.003;

/// Whether a stage closes a loop through the velocity of the motor; another one does not change its stability.
pub(crate) fn looks_at_motor(mode: Mode) -> bool {
    match mode {
        Mode::Direct { source: DirectSource::Motor } | Mode::Indirect { .. } => true,
        Mode::Direct { source: DirectSource::Direct } | Mode::SetPoint { .. } => false,
    }
}

/// The stages of an axis that close the loop.
pub(crate) fn stages(designed: &Designed) -> impl Iterator<Item = &StageDesign> {
    designed.stage.iter().flatten().filter(|design| looks_at_motor(design.stage.mode))
}

/// The controller of an axis at the points of the frequency axis that these drives need; none: no stage closes a loop.
pub(crate) fn points<'d>(designed: &'d Designed, drives: &[Drive<'_>]) -> Option<Points<'d>> {
    let mut coeffs: [Option<Coeffs<f64>>; STAGES] = [None; STAGES];
    let mut weight = [0.0; STAGES];
    let mut bands = Vec::new();
    for design in stages(designed) {
        coeffs[design.index] = Some(Coeffs { gain: -1.0, ..design.coeffs });
        weight[design.index] = design.stage.weight();
        let filters = design.stage.filter.iter().filter_map(Filter::f0_and_q);
        bands.extend(filters.map(|[f0, q_factor]| Band { centre: f0, width: f0 / q_factor }));
    }
    if bands.is_empty() {
        return None;
    }
    let controller = Controller {
        cycle_time: designed.axis.cycle_time(),
        weight,
        stage: Box::new(move |t| coeffs.each_ref().map(|of| of.as_ref().map_or(ZERO, |of| response::of_stage(of, t)))),
        bands,
        position_gain: designed.axis.drive.position_gain,
    };
    Some(Points::new(controller, drives))
}

const ZERO: Complex64 = Complex64::new(0.0, 0.0);

/// The drive that a set states; none: it states none.
pub(crate) fn stated(model: &DriveModel) -> Option<Drive<'_>> {
    match &model.response {
        Some(measured) => Some(Drive::Measured(&measured.response)),
        None if model.is_given() => {
            Some(Drive::Delay { cycles: model.delay_cycles.unwrap_or(USUAL_DELAY), time_constant: model.time_constant })
        }
        None => None,
    }
}

/// A drive without mechanics, in words.
pub(crate) fn words(drive: &Drive<'_>) -> String {
    match *drive {
        Drive::Delay { cycles, time_constant: None } => format!("a drive that only delays {}", cycles_text(cycles)),
        Drive::Delay { cycles, time_constant: Some(time) } => {
            format!("a delay of {} and a time constant of {} ms", cycles_text(cycles), significant(time * 1e3, 4))
        }
        Drive::Measured(_) => "the measured drive".to_owned(),
    }
}

fn cycles_text(cycles: f64) -> String {
    format!("{} cycle{}", significant(cycles, 4), if cycles > 1.0 { "s" } else { "" })
}
