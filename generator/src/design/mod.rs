//! The mathematics around the design of a stage: delays, scalings, responses, rounding; the only place with trigonometry. No
//! parameter, no axis, no block. The numbers of a stage come from `reference::design`.
//!
//! Everything is computed in f64 with the `libm` crate, so that every host gets the same bits. A coefficient is rounded
//! once, in `rounding`.

pub(crate) mod band;
pub(crate) mod delay;
pub(crate) mod response;
pub(crate) mod rounding;
pub(crate) mod scale;
pub(crate) mod trapezoidal;
