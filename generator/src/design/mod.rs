//! The mathematics around the design of a stage: delays, scalings, responses, rounding; the only place with trigonometry. No
//! parameter, no axis, no block. The numbers of a stage come from `reference::design`.
//!
//! Everything is computed in f64 with the `libm` crate, so that every host gets the same bits. A coefficient is rounded
//! once, in `rounding`.

pub mod band;
pub mod delay;
pub mod response;
pub mod rounding;
pub mod scale;
pub(crate) mod trapezoidal;
