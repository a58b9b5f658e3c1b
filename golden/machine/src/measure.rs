//! The vibrations of the demonstration plant in a record: amplitudes, ring-down, following error. Computed by a plain
//! Fourier sum, because only a few frequencies are needed.

use super::closed_loop::Record;
use portable::{Extreme, peak};
use std::f64::consts::TAU;

/// The columns of the table of the application example.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures {
    /// amplitude of x2'' at constant speed, 50 to 56 Hz [m/s^2]
    pub at_speed: f64,
    /// amplitude of x2'' around the ramps, 9.5 to 12.5 Hz [m/s^2]
    pub at_ramps: f64,
    /// peak of x2'' after the ramps, 7 to 18 Hz [m/s^2]
    pub ring_down: f64,
    /// peak of |command - q1|, both at the start of a cycle [m]
    pub following_error: f64,
}

/// All columns of the table.
#[must_use]
pub fn figures(record: &Record) -> Figures {
    Figures {
        at_speed: mean(dwells(record).map(|window| amplitude(&record.sensor[window], record.cycle, [50.0, 56.0]))),
        at_ramps: mean(ramps(record).map(|window| amplitude(&record.sensor[window], record.cycle, [9.5, 12.5]))),
        ring_down: ring_down(record),
        following_error: following_error(record),
    }
}

/// The largest difference between the command and the motor's position [m]: `max |x[n] - q1(n Ts)|`, with the command that
/// the controller gets at the start of cycle n. The command of a [`Sequence`](super::sequence::Sequence) is ahead by a
/// cycle: at constant speed the controller, which reads the position a cycle late, has a difference of 0, and this
/// difference is -Ts v.
#[must_use]
pub fn following_error(record: &Record) -> f64 {
    let errors = record.command.iter().zip(&record.x).map(|(x, actual)| (x - actual).abs());
    errors.fold(0.0, f64::larger)
}

/// A range of cycles of a record.
pub type Window = std::ops::Range<usize>;

/// The number of cycles of a time [s].
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousand cycles")]
fn cycles(record: &Record, time: f64) -> usize {
    libm::round(time / record.cycle) as usize
}

/// Windows at constant speed: from 0.4 s after a ramp's end to the start of the next ramp.
pub fn dwells(record: &Record) -> impl Iterator<Item = Window> {
    let settle = cycles(record, 0.4);
    record.ramps.chunks(2).map(move |pair| pair[0][1] + settle..pair[1][0])
}

/// Windows of 1.0 s from 0.1 s before each ramp's start.
pub fn ramps(record: &Record) -> impl Iterator<Item = Window> {
    let (before, length) = (cycles(record, 0.1), cycles(record, 1.0));
    record.ramps.iter().map(move |[start, _]| start - before..start - before + length)
}

/// The whole record through an ideal band-pass from 7 to 18 Hz: the peak from 0.08 to 0.6 s after each ramp's end, mean of
/// the ramps.
fn ring_down(record: &Record) -> f64 {
    let filtered = brick_wall(&record.sensor, record.cycle, [7.0, 18.0]);
    let (from, to) = (cycles(record, 0.08), cycles(record, 0.6));
    mean(record.ramps.iter().map(|[_, end]| peak(&filtered[end + from..end + to])))
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let values: Vec<f64> = values.collect();
    values.iter().sum::<f64>() / values.len() as f64
}

/// Values without their mean.
#[must_use]
pub fn without_mean(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let values: Vec<f64> = values.collect();
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.iter().map(|value| value - mean).collect()
}

/// The largest amplitude within a band [Hz]: Hann window, padded with zeros to eight times the length. 1 for a sine of
/// amplitude 1.
/// amplitude 1.
#[must_use]
pub fn amplitude(samples: &[f64], cycle: f64, band: [f64; 2]) -> f64 {
    spectrum(samples, cycle, band).into_iter().fold(0.0, |largest, [_, amplitude]| amplitude.larger(largest))
}

/// Frequency [Hz] and amplitude, line by line within a band [Hz]: Hann window, padded with zeros to eight times the length.
#[must_use]
pub fn spectrum(samples: &[f64], cycle: f64, band: [f64; 2]) -> Vec<[f64; 2]> {
    let length = samples.len() as f64;
    let window = |n: usize| 0.5 - 0.5 * libm::cos(TAU * n as f64 / length);
    let windowed: Vec<f64> = samples.iter().enumerate().map(|(n, sample)| sample * window(n)).collect();
    let line = 1.0 / (8.0 * length * cycle);
    let lines = (0u32..).map(|k| f64::from(k) * line).skip_while(|f| *f < band[0]).take_while(|f| *f <= band[1]);
    // The mean of the window is 1/2: the amplitude of a sine is 2 |sum| / (length / 2).
    lines.map(|f| [f, 4.0 / length * magnitude(fourier(&windowed, TAU * f * cycle))]).collect()
}

fn magnitude([re, im]: [f64; 2]) -> f64 {
    libm::sqrt(re * re + im * im)
}

/// Sum of x\[n\] exp(-j w n), w in rad per sample: the factor is rotated from sample to sample.
#[must_use]
pub fn fourier(samples: &[f64], w: f64) -> [f64; 2] {
    let (cos, sin) = (libm::cos(w), -libm::sin(w));
    let (mut turn, mut sum) = ([1.0, 0.0], [0.0, 0.0]);
    for sample in samples {
        sum = [sum[0] + sample * turn[0], sum[1] + sample * turn[1]];
        turn = [turn[0] * cos - turn[1] * sin, turn[0] * sin + turn[1] * cos];
    }
    sum
}

/// The part of a record within a band [Hz], including both edges.
#[must_use]
pub fn brick_wall(samples: &[f64], cycle: f64, band: [f64; 2]) -> Vec<f64> {
    let length = samples.len() as f64;
    let mut filtered = vec![0.0; samples.len()];
    let lines = (1u32..).map(f64::from).skip_while(|k| k / (length * cycle) < band[0]);
    for k in lines.take_while(|k| k / (length * cycle) <= band[1]) {
        let w = TAU * k / length;
        let [re, im] = fourier(samples, w);
        let (cos, sin) = (libm::cos(w), libm::sin(w));
        let mut turn = [1.0, 0.0];
        for filtered in &mut filtered {
            *filtered += 2.0 / length * (re * turn[0] - im * turn[1]);
            turn = [turn[0] * cos - turn[1] * sin, turn[0] * sin + turn[1] * cos];
        }
    }
    filtered
}
