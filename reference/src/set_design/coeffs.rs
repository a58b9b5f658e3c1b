//! Coefficients of the block `set_design`. Nothing is computed here.

use crate::design::inputs;
use crate::design::poles::Prototype;
use crate::ipc::STAGES;
use crate::sets;
use crate::stage::FILTERS;
use portable::portable;

/// The prototypes of the filters of a stage.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Prototypes {
    /// low-pass prototype of each band-pass (P-AXIS-00848)
    pub filter: [Prototype; FILTERS],
}

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// lowest centre frequency [Hz]: the fade and the watch of the block that takes the set count in its periods
    pub lowest_f0: R,
    /// highest centre frequency [Hz]: 500, and f0 Ts = 0.45
    pub highest_f0: R,
    /// prototypes of the stages
    pub prototype: [Prototypes; STAGES],
    /// largest velocity (P-AXIS-00212): the sum of stages at it is not a fault [um/s or 0.001 deg/s]
    pub v_max: R,
    /// values of the inputs that the block was generated with
    pub generated: [inputs::Inputs<R>; STAGES],
    /// the block that takes the set
    pub set: sets::Coeffs<R>,
}
