//! Inputs and outputs of the block `set_design`. Nothing is computed here.

use crate::design::inputs;
use crate::ipc::STAGES;
use crate::ipc::numbers::Params;
use portable::portable;

/// Inputs. Velocities are in um/s for a translatory axis, in 0.001 deg/s for a rotary axis or a spindle.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Inputs<R> {
    /// the rising edge starts a design, also while one is active; the other inputs must not change until active is FALSE
    pub execute: bool,
    /// largest |v_add| of the set, from 0 to the limit of the block that takes it (P-AXIS-00757) [um/s or 0.001 deg/s]
    pub limit: R,
    /// the stages
    pub stage: [inputs::Inputs<R>; STAGES],
}

/// Outputs.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Outputs<R> {
    /// TRUE while a set is designed: call the block again
    pub active: bool,
    /// params is the complete set of the last design: of the inputs since the rising edge of execute, which must not
    /// change while active is TRUE
    pub designed: bool,
    /// the last design was refused: the error id gives the reason, and params is not a set
    pub fault: bool,
    /// why the design was refused: 0 none
    pub error_id: u32,
    /// number of the stage whose input was refused, from 0; 0 if it was the limit
    pub wrong_stage: u32,
    /// number of the filter in its stage whose input was refused, from 0; 0 for a weight, a damping ratio or the limit
    pub wrong_filter: u32,
    /// the parameter set; all of it is 0 unless designed is TRUE
    pub params: Params<R>,
}
