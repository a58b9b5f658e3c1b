//! From a recording to a proposal: the excitation of an axis, its response, its vibrations, the effect of stages of improved
//! position control on them, and proposed stages. No parameter, no file, no block: arrays in, numbers out; the response of a
//! stage is a closure of the caller.
//!
//! Velocities are in one unit of the caller's, times in seconds, frequencies in Hz. z^-1 = exp(-j 2 pi f T), T the
//! cycle of the position controller. P is the response from the commanded velocity `v_cmd` to the motor's `v_motor`;
//! C, L and S are those of the crate `stability`.
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler
#![forbid(unsafe_code)]

pub mod dead_time;
pub mod decay;
pub mod excitation;
pub mod figures;
mod fourier;
mod least_squares;
pub mod offset;
pub mod peaks;
pub mod proposals;
pub mod resonance;
pub mod response;
pub mod scenarios;
mod search;
pub mod segments;
pub mod shape;
pub mod source;
mod welch;
pub mod what_if;

pub use stability::Complex64;
use stability::{angle, magnitude, turned};

const ZERO: Complex64 = Complex64::new(0.0, 0.0);

/// The next whole number of samples.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn whole(samples: f64) -> usize {
    libm::round(samples) as usize
}
