//! The loop of an axis with several drives: margins, and the largest weights of its stages. No file.

mod lead;
mod text;

pub use crate::blocks::ipc::closed_loop::{Known, looks_at_load, looks_at_motor, on_a_rigid_axis};
pub use text::{STAGE, headline, margins, outside, stage_cells, text};

use crate::axis::{DriveModel, Stage};
use crate::blocks::Designed;
use crate::blocks::ipc::closed_loop;
use crate::blocks::ipc::stage::{self, StageDesign};
use crate::design::response;
use portable::Extreme;
use serde::Serialize;
use stability::{Complex64, Curve, Loop, Margins, Points};

/// Points of a curve between its lowest frequency, a part of the lowest f0, and the Nyquist frequency.
const LINES: u32 = 600;
const LOWEST: f64 = 1.0 / 20.0;

/// An axis, and its loop with each drive.
pub struct Analysis {
    /// empty if no stage closes a loop
    pub drives: Vec<OfDrive>,
}

/// A loop.
pub struct OfDrive {
    pub drive: Known,
    pub margins: Margins,
    /// the stages that close the loop
    pub stages: Vec<OfStage>,
    /// lag of the drive alone at the f0 of each stage that looks at the motor [degrees]: 0 to 360, or -90 to 270 with a position
    /// controller of its own
    pub lag: Vec<(usize, f64)>,
    /// by frequency
    pub curve: Vec<Curve>,
}

/// A stage in a loop.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct OfStage {
    pub stage: usize,
    pub weight: f64,
    /// phase of the stage and the drive together at the stage's f0, in (-360, 0]
    pub phase_at_f0_deg: f64,
    /// weights up to which the loop is stable, and up to which Ms stays within 2; the other stages unchanged
    pub largest_stable_weight: f64,
    pub largest_weight: f64,
}

/// The loop of an axis with the drive that the model states, else with two usual drives; and with the ideal drive.
#[must_use]
pub fn analyze(designed: &Designed, model: &DriveModel) -> Analysis {
    let mut drives = Known::of(model);
    if !drives.contains(&Known::IDEAL) {
        drives.push(Known::IDEAL);
    }
    let Some(points) = closed_loop::points(designed, &drives, model.position_gain) else {
        return Analysis { drives: Vec::new() };
    };
    Analysis { drives: drives.into_iter().map(|drive| of_drive(designed, &points, drive)).collect() }
}

fn of_drive(designed: &Designed, points: &Points<'_>, drive: Known) -> OfDrive {
    let closed = Loop::new(points, drive.drive());
    let stage = |design: &StageDesign| {
        let [largest_stable_weight, largest_weight] = closed.largest_weights(design.index);
        OfStage {
            stage: design.index,
            weight: design.stage.weight(),
            phase_at_f0_deg: closed.phase(design.index, design.stage.f0()),
            largest_stable_weight,
            largest_weight,
        }
    };
    let stages = closed_loop::stages(designed).map(stage).collect();
    let lag = |design: &StageDesign| (design.index, closed.lag(design.stage.f0()));
    let motor = closed_loop::stages(designed).filter(|design| looks_at_motor(design.stage.mode));
    let lag = motor.map(lag).collect();
    let (margins, curve) = (closed.margins(), curve(designed, &closed));
    OfDrive { drive, margins, stages, lag, curve }
}

/// The loop at the points of its margins, and at evenly spaced points on a logarithmic scale.
fn curve(designed: &Designed, closed: &Loop<'_>) -> Vec<Curve> {
    let nyquist = 0.5 / designed.axis.cycle_time();
    let lowest = closed_loop::stages(designed).map(|design| design.stage.f0()).fold(nyquist, f64::smaller) * LOWEST;
    let hz = |k: u32| lowest * libm::pow(nyquist / lowest, f64::from(k) / f64::from(LINES));
    let mut curve = closed.curve();
    curve.extend((0..LINES).map(|k| closed.at_frequency(hz(k))));
    curve.sort_by(|a, b| a.hz.total_cmp(&b.hz));
    curve
}

/// The response of a stage from its input velocity to its output, with weight and sign, from the coefficients that a block
/// has at a cycle time T [s]: a function of t = tan(pi f T).
pub fn of_stage(stage: &Stage, cycle_time: f64) -> impl Fn(f64) -> Complex64 + use<> {
    let stage = response::Stage::new(&stage::stage(0, stage, cycle_time).coeffs);
    move |t| stage.at(t)
}
