//! An axis with all results of the design, made once. Blocks, notes, certificates, summaries and the semantic diff use it.
//! No text, no program.

use super::feedforward::design as feedforward;
use super::ipc::{design as ipc, sets, stage::StageDesign};
use super::position_control::design as position_control;
use super::set_design::design as set_design;
use super::spindle::design as spindle;
use crate::axis::Axis;
use reference::ipc::STAGES;

/// A designed axis. All coefficients are in double precision; `axis.real` is the type that they are rounded to.
#[derive(Clone, Debug)]
pub struct Designed {
    pub axis: Axis,
    /// the stages of improved position control; an inactive one is `None`
    pub stage: [Option<StageDesign>; STAGES],
    pub ipc: reference::ipc::Coeffs<f64>,
    /// the structure id and the set number of its parameters; 0 if it takes no sets
    pub sets: [u32; 2],
    /// all 0 if the controller designs no sets
    pub set_design: reference::set_design::Coeffs<f64>,
    /// all 0 without feedforward
    pub feedforward: reference::feedforward::Coeffs<f64>,
    /// all 0 without position control
    pub position_control: reference::position_control::Coeffs<f64>,
    /// all 0 without a changeover
    pub spindle: reference::spindle::Coeffs<f64>,
}

/// Two designs of equal axes are equal.
impl PartialEq for Designed {
    fn eq(&self, other: &Self) -> bool {
        self.axis == other.axis
    }
}

impl From<Axis> for Designed {
    fn from(axis: Axis) -> Self {
        let (stage, ipc) = ipc::design(&axis);
        let feedforward = feedforward::coefficients(&axis);
        let position_control = position_control::coefficients(&axis);
        let spindle = spindle::coefficients(&axis);
        let sets = if axis.ipc.takes_sets() { sets::sets(&axis, &ipc) } else { [0; 2] };
        let set_design = set_design::coefficients(&axis, &stage, sets, &ipc);
        Self { axis, stage, ipc, sets, set_design, feedforward, position_control, spindle }
    }
}
