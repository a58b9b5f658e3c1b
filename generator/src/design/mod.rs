//! The mathematics of design: from frequencies, quality factors, scalings to numbers; the only place with trigonometry. No
//! parameter, no axis, no block.
//!
//! ```text
//! band         f0, Q, Ts -> warped centre and bandwidth
//! prototype    prototype, order -> poles of the low-pass
//! bandpass     poles, band -> sections, in the order of their execution -> coefficients
//! allpass      band -> coefficients
//! oscillation  warped centre, damping ratio -> coefficients
//! delay        time, cycle -> whole cycles and a fraction
//! scale        what the drive gets for a velocity, an acceleration
//! response     what coefficients do
//! rounding     coefficients in double precision -> in the block's own real type
//! ```
//!
//! Everything is computed in f64 with the `libm` crate, so that every host finds the same bits; a coefficient is rounded once,
//! in `rounding`.

pub mod allpass;
pub mod band;
pub mod bandpass;
pub mod delay;
pub mod denominator;
pub mod oscillation;
pub mod prototype;
pub mod response;
pub mod rounding;
pub mod scale;
