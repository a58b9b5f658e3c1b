//! The dead time of an axis: what its phase turns beyond the minimum phase of its magnitude; what it says of the
//! channels. No offset of channels.

use crate::offset::{Phasor, Time, delay};
use crate::response::Lines;
use crate::{Complex64, fourier, magnitude, turned};
use portable::Extreme;
use std::f64::consts::TAU;

/// How near to half the sampling frequency the lines have to come, as a part of it.
const NYQUIST: f64 = 0.98;
/// A standard error counts as that part of the magnitude at the least.
const LEAST_ERROR: f64 = 1e-3;
/// How far from whole cycles a dead time may lie [s].
const FROM_WHOLE: f64 = 0.15e-3;

/// The dead time of P [s]: the slope of its phase beyond the minimum phase of |P|, the Hilbert transform of ln |P|.
///
/// The lines have to be evenly spaced from the first one, 1/(N T), to half the sampling frequency: an excitation with
/// clocks of one cycle. None: they are not, or do not agree. Of signals that the controller's task samples it is a
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
/// The cepstrum, the inverse transform of ln |P|, is even; of the minimum phase it is that of rising time, twice.
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

/// What a dead time says of the two channels.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Channels {
    /// a whole number of cycles: both may be recorded by the task that runs the block. Whole cycles more or less
    /// cannot be seen
    Whole(u32),
    /// not a whole number of cycles: a channel is from elsewhere
    NotWhole,
    /// below one cycle: no controller is as fast
    TooShort,
}

impl Channels {
    /// By a dead time [s] at a cycle time T [s].
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
