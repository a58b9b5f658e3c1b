//! The block that designs sets, from the parameters of its axis: its structure, and the start values of its inputs. No text.

use super::super::ipc::{sets, stage::StageDesign};
use crate::axis::Axis;
use reference::design::inputs::highest_f0;
use reference::ipc::{Coeffs as IpcCoeffs, STAGES};
use reference::set_design::{Coeffs, Prototypes};

/// Designs it; all 0 if the controller designs no sets.
pub(crate) fn coefficients(
    axis: &Axis,
    stage: &[Option<StageDesign>; STAGES],
    [structure, set_id]: [u32; 2],
    ipc: &IpcCoeffs<f64>,
) -> Coeffs<f64> {
    let Some(lowest_f0) = axis.ipc.lowest_f0() else { return Coeffs::default() };
    let prototypes = |stage: &StageDesign| Prototypes { filter: stage.prototypes };
    Coeffs {
        lowest_f0,
        highest_f0: highest_f0(axis.cycle_time_ns),
        v_max: axis.ipc.v_max,
        prototype: stage.each_ref().map(|stage| stage.as_ref().map_or_else(Default::default, prototypes)),
        generated: stage.each_ref().map(|stage| stage.as_ref().map_or_else(Default::default, |stage| stage.inputs)),
        set: sets::with(structure, set_id, ipc),
    }
}
