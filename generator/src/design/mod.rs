//! The mathematics of design: from frequencies, quality factors, scalings to numbers; the only place with trigonometry. No
//! parameter, no axis, no block.
//!
//! ```text
//! band         f0, Q, Ts -> warped centre and bandwidth
//! bandpass     prototype, order, band -> sections, in the order of their execution
//! section      warped centre, damping -> coefficients of a band-pass, an all-pass, the simulated oscillation
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
pub(crate) mod bandpass;
pub(crate) mod delay;
pub(crate) mod response;
pub(crate) mod rounding;
pub(crate) mod scale;
pub(crate) mod section;
pub(crate) mod trapezoidal;
