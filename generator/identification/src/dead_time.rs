//! The dead time of an axis: the phase beyond the minimum phase of its magnitude; and its meaning for the channels. No
//! offset of channels.

use crate::offset::{Phasor, Time, delay};
use crate::response::Lines;
use crate::{Complex64, fourier, magnitude, turned};
use portable::Extreme;
use std::f64::consts::TAU;

/// The lines must come this close to half the sampling frequency, as a part of it.
const NYQUIST: f64 = 0.98;
/// Lower limit of a standard error, as a part of the magnitude.
const LEAST_ERROR: f64 = 1e-3;
/// Largest distance of a dead time from whole cycles [s].
const FROM_WHOLE: f64 = 0.15e-3;

/// The dead time of P [s]: the slope of its phase beyond the minimum phase of |P|, the Hilbert transform of ln |P|.
///
/// The lines must be evenly spaced from the first one, 1/(N T), to half the sampling frequency: an excitation with clocks of
/// one cycle. `None` if they are not, or if they are inconsistent. For signals that the controller's task samples, it is a
/// whole number of cycles: those of the bus and one more.
#[must_use]
pub fn of(lines: &Lines, cycle_time: f64) -> Option<Time> {
    let spacing = *lines.hz.first()?;
    let is_even = |(k, hz): (usize, &f64)| libm::fabs(hz / spacing - (k + 1) as f64) < 1e-3;
    if !lines.hz.iter().enumerate().all(is_even) || *lines.hz.last()? < NYQUIST * 0.5 / cycle_time {
        return None;
    }
    let phasors: Vec<Phasor> = (lines.hz.iter().enumerate().zip(minimum_phase(lines)))
        .map(|((k, hz), minimum)| {
            let (p, size) = (lines.response[k], magnitude(lines.response[k]));
            let error = (lines.error[k] / size).larger(LEAST_ERROR);
            Phasor { omega: TAU * hz, unit: p / size * turned(-minimum), weight: 2.0 / (error * error) }
        })
        .collect();
    delay(&phasors)
}

/// The phases of a system without dead time and with these magnitudes, at its lines. |P| is 1 at 0 Hz.
///
/// The cepstrum, the inverse transform of ln |P|, is even. The minimum phase belongs to its part at positive time, doubled.
fn minimum_phase(lines: &Lines) -> Vec<f64> {
    let logarithm = |p: &Complex64| Complex64::from(0.5 * libm::log(p.norm_sqr()));
    let logarithms: Vec<Complex64> =
        std::iter::once(Complex64::from(0.0)).chain(lines.response.iter().map(logarithm)).collect();
    let length = 2 * lines.response.len() + 1;
    let mut cepstrum = fourier::real_of(&logarithms, length);
    let half = length.div_ceil(2);
    cepstrum[1..half].iter_mut().for_each(|value| *value *= 2.0);
    cepstrum[half..].fill(0.0);
    fourier::of_real(&cepstrum)[1..].iter().map(|line| line.im).collect()
}

/// The meaning of a dead time for the two channels.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Channels {
    /// a whole number of cycles: both may be recorded by the task that runs the block. An offset of whole cycles cannot be
    /// detected
    Whole(u32),
    /// not a whole number of cycles: a channel has another source
    NotWhole,
    /// below one cycle: no controller is that fast
    TooShort,
}

impl Channels {
    /// The meaning of a dead time [s] at a cycle time T [s].
    #[must_use]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at least one, saturates")]
    pub fn of(dead_time: f64, cycle_time: f64) -> Self {
        let cycles = libm::round(dead_time / cycle_time);
        if dead_time < cycle_time - FROM_WHOLE || cycles < 1.0 {
            return Self::TooShort;
        }
        let is_whole = libm::fabs(dead_time - cycles * cycle_time) <= FROM_WHOLE;
        if is_whole { Self::Whole(cycles as u32) } else { Self::NotWhole }
    }
}
