//! The loop that improved position control closes: its stability, its margins, and its largest weights. No parameter, no
//! file, no block: a controller is a closure that returns numbers, a measured response is two arrays.
//!
//! # The loop
//! The loop is cut at the commanded velocity, `v_cmd = v_command + v_add`, and described at the sampling instants.
//!
//! ```text
//! C(f) = sum of w_i C_i(f)             from v_motor to v_add: the active stages with the input v_motor, with their signs;
//!                                      -Kv T z^-1/(1 - z^-1) C_i for one with the input v_command of a position controller
//! P(f)                                 from v_cmd to v_motor, including every delay
//! L(f) = -C P + Kv T z^-1/(1 - z^-1) P the second term only with a position controller with the gain Kv
//! S(f) = 1/(1 + L)                     stable: 1 + L does not turn around 0
//! Ms   = largest |S|                   1/Ms is the distance of L from -1
//! ```
//!
//! C and P are stable, so the closed loop is stable if 1 + L does not turn around 0 (Nyquist). z^-1 = exp(-j 2 pi f T); the
//! frequency axis is t = tan(pi f T), which keeps all digits at low frequencies.
//!
//! ```text
//! frequency  points of the frequency axis, and a controller there
//! response   a measured response between its lines
//! drive      the model of the drive: P
//! driven     a controller with P at its points
//! crossing   the largest weight at a frequency
//! part       a loop with a growing part: turns, crossings, the least distance
//! margins    Ms, gain and phase margin, largest weights
//! ```
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler

mod crossing;
mod drive;
mod driven;
mod frequency;
mod margins;
mod part;
mod response;
mod search;

pub use crossing::{Line, largest_within};
pub use drive::Drive;
pub use frequency::{Band, Controller, Points, position};
pub use margins::{Curve, Loop, MAX_MS, Margins};
pub use num_complex::Complex64;
pub use response::Response;

/// Stages of improved position control.
pub const STAGES: usize = 3;
/// The largest weight of a stage (P-AXIS-00754).
pub const LARGEST_WEIGHT: f64 = 7.0;

/// sqrt(re^2 + im^2): the square root is exact on every host, and no square of a response overflows.
#[must_use]
pub fn magnitude(value: Complex64) -> f64 {
    value.norm_sqr().sqrt()
}

/// The angle in (-pi, pi].
#[must_use]
pub fn angle(value: Complex64) -> f64 {
    libm::atan2(value.im, value.re)
}

/// exp(j angle).
#[must_use]
pub fn turned(angle: f64) -> Complex64 {
    let (sin, cos) = libm::sincos(angle);
    Complex64::new(cos, sin)
}
