//! From a recording to a proposal: how an axis is excited, its response, its vibrations, what stages of improved
//! position control would leave of them, which stages are proposed. No parameter, no file, no block: arrays in,
//! numbers out; the response of a stage is a closure of the caller.
//!
//! Velocities are in one unit of the caller's, times in seconds, frequencies in Hz. z^-1 = exp(-j 2 pi f T), T the
//! cycle of the position controller. P is the response from the commanded velocity `v_cmd` to the motor's `v_motor`;
//! C, L and S are those of the crate `stability`.
//!
//! ```text
//! fourier        transforms of any length
//! excitation     the maximum-length sequence, and what a start of it means
//! response       periods -> P with its standard errors; smoothing
//! welch          spectra of signals without a period
//! offset         how much later one channel is than another
//! dead_time      what the phase of P turns beyond its minimum phase
//! segments       rest, driving, ramps of a record
//! peaks          of the spectrum while driving
//! least_squares  linear fits
//! decay          frequency and damping of a vibration after ramps
//! resonance      the same from a response
//! source         on which side of the spring a vibration enters
//! shape          a stage but for its weight
//! what_if        a record as it would have been with stages
//! figures        what is left of its vibrations
//! scenarios      the drives that a proposal has to bear, and the weight that they bear
//! search         shapes and weights that leave the least
//! proposals      recommended, strong, cautious; first ones without a response
//! ```
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
use stability::magnitude;

const ZERO: Complex64 = Complex64::new(0.0, 0.0);

/// exp(j angle).
fn turned(angle: f64) -> Complex64 {
    let (sin, cos) = libm::sincos(angle);
    Complex64::new(cos, sin)
}

/// The angle in (-pi, pi].
fn angle(value: Complex64) -> f64 {
    libm::atan2(value.im, value.re)
}

/// The next whole number of samples.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn whole(samples: f64) -> usize {
    libm::round(samples) as usize
}
