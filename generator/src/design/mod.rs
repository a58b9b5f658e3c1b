//! The mathematics around the design of a stage: delays, scalings, responses, rounding; the only place with trigonometry. No
//! parameter, no axis, no block. The numbers of a stage come from `reference::design`.
//!
//! ```text
//! band         edges of a band, points of the warped frequency axis
//! trapezoidal  a section of single precision: step, response
//! delay        time, cycle -> whole cycles and a fraction
//! scale        scalings of velocities and accelerations for the drive
//! response     frequency response of coefficients
//! rounding     coefficients in double precision -> in the block's own real type
//! ```
//!
//! Everything is computed in f64 with the `libm` crate, so that every host gets the same bits. A coefficient is rounded
//! once, in `rounding`.

pub(crate) mod band;
pub(crate) mod delay;
pub(crate) mod response;
pub(crate) mod rounding;
pub(crate) mod scale;
pub(crate) mod trapezoidal;
