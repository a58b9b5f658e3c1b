//! A record as it would have been with stages: disturbances at the motor are multiplied by R = S/S0. Nothing is measured on
//! it.

use crate::fourier::Fourier;
use crate::shape::{Shape, Stages, sum};
use crate::{Complex64, ZERO};
use portable::Extreme;
use std::f64::consts::PI;

/// The axis whose loop is closed.
#[derive(Clone, Copy, Debug)]
pub struct Axis<'a> {
    /// T [s]
    pub cycle_time: f64,
    /// gain Kv [1/s] of the position controller, if its loop is closed
    pub position_gain: Option<f64>,
    /// P; P is interpolated, never S
    pub response: &'a stability::Response,
}

impl Axis<'_> {
    /// 1 + L0 and P at t = tan(pi f T), f > 0.
    pub(crate) fn at(&self, t: f64) -> [Complex64; 2] {
        let hz = libm::atan(t) / (PI * self.cycle_time);
        let p = self.response.value(hz);
        [rest(self, t, p), p]
    }
}

/// 1 + L0 for a given P: the position is the integral of the velocity, as an encoder reads it at the same instant.
///
/// L0 = Kv T/2 (1 + z^-1)/(1 - z^-1) P, and (1 + z^-1)/(1 - z^-1) = 1/(j t). The loop of the crate `stability` sums the
/// velocities of the previous cycles, half a cycle later: its |S| is up to a few percent larger.
pub(crate) fn rest(axis: &Axis<'_>, t: f64, p: Complex64) -> Complex64 {
    let position = Complex64::new(0.0, -0.5 / t) * (axis.position_gain.unwrap_or(0.0) * axis.cycle_time);
    position * p + 1.0
}

/// Signals of one record with the stages off, of equal length, at rest at both ends; and the axis.
pub struct WhatIf<'a> {
    axis: Axis<'a>,
    /// t at the frequencies of the lines, without 0 Hz
    t: Vec<f64>,
    /// 1 + L0 and P at the lines
    rest: Vec<Complex64>,
    p: Vec<Complex64>,
    /// the transforms of the signals, from 0 Hz
    signals: Vec<Vec<Complex64>>,
    inverse: Fourier,
    /// number of samples of the record, and record samples per sample of the result
    samples: usize,
    part: f64,
}

impl<'a> WhatIf<'a> {
    /// From signals. With a highest frequency [Hz], higher frequencies are left out, and fewer samples are returned.
    #[must_use]
    pub fn new(axis: Axis<'a>, signals: &[&[f64]], highest: Option<f64>) -> Self {
        let samples = signals.iter().map(|signal| signal.len()).max().unwrap_or(0);
        // Padded to twice the length: the decay after the end of the record does not reappear at its beginning.
        let forward = Fourier::at_least(2 * samples);
        let length = forward.length();
        let wanted = highest.map_or(1.0, |hz| (2.0 * hz * axis.cycle_time).smaller(1.0)) * length as f64;
        let inverse = Fourier::at_least(crate::whole(libm::ceil(wanted)));
        let lines = inverse.length() / 2;
        let t: Vec<f64> = (1..lines).map(|k| libm::tan(PI * k as f64 / length as f64)).collect();
        let known: Vec<[Complex64; 2]> = t.iter().map(|t| axis.at(*t)).collect();
        let transform = |signal: &&[f64]| {
            let mut values: Vec<Complex64> = signal.iter().map(|x| Complex64::from(*x)).collect();
            values.resize(length, ZERO);
            forward.forward(&mut values);
            values.truncate(lines);
            values
        };
        Self {
            axis,
            t,
            rest: known.iter().map(|known| known[0]).collect(),
            p: known.iter().map(|known| known[1]).collect(),
            signals: signals.iter().map(transform).collect(),
            part: inverse.length() as f64 / length as f64,
            inverse,
            samples,
        }
    }

    /// The time between returned samples [s].
    #[must_use]
    pub fn step(&self) -> f64 {
        self.axis.cycle_time / self.part
    }

    /// The distance of the lines [Hz].
    fn spacing(&self) -> f64 {
        1.0 / (self.step() * self.inverse.length() as f64)
    }

    /// The lines without 0 Hz.
    #[must_use]
    pub fn lines(&self) -> usize {
        self.t.len()
    }

    /// C at the lines without 0 Hz.
    #[must_use]
    pub fn controller(&self, stages: &Stages<'_>, of: &[(Shape, f64)]) -> Vec<Complex64> {
        sum(stages, of, &self.t)
    }

    /// A response, a function of t = tan(pi f T), at the lines from the first one on.
    pub fn at_lines(&self, response: impl Fn(f64) -> Complex64) -> Vec<Complex64> {
        self.t.iter().map(|t| response(*t)).collect()
    }

    /// R = S/S0 = (1 + L0)/(1 + L0 - C P) at the lines from the first one on.
    #[must_use]
    pub fn left(&self, controller: &[Complex64]) -> Vec<Complex64> {
        let of = |((rest, p), c): ((&Complex64, &Complex64), &Complex64)| rest / (rest - c * p);
        self.rest.iter().zip(&self.p).zip(controller).map(of).collect()
    }

    /// A signal times a response at its lines, completely and within a band [Hz] only. At 0 Hz the factor is a real number;
    /// this line is not part of a band.
    #[must_use]
    pub fn signal(&self, signal: usize, response: &[Complex64], at_0: f64, band: [f64; 2]) -> [Vec<f64>; 2] {
        let lines = &self.signals[signal];
        self.samples(lines[0] * at_0, lines[1..].iter().zip(response).map(|(line, response)| line * response), band)
    }

    /// The following error, a signal, with the stages that leave R: e + T sum(v - R v), where v is the velocity of the motor,
    /// another signal; completely and within a band [Hz] only.
    ///
    /// The sum is 1/(1 - z^-1) = (1 + 1/(j t))/2.
    #[must_use]
    pub fn error(&self, [error, motor]: [usize; 2], left: &[Complex64], band: [f64; 2]) -> [Vec<f64>; 2] {
        let [error, motor] = [error, motor].map(|signal| &self.signals[signal]);
        let lag = |((v, left), t): ((&Complex64, &Complex64), &f64)| {
            v * (1.0 - left) * Complex64::new(0.5, -0.5 / t) * self.axis.cycle_time
        };
        let lags = motor[1..].iter().zip(left).zip(&self.t).map(lag);
        self.samples(error[0], error[1..].iter().zip(lags).map(|(error, lag)| error + lag), band)
    }

    /// The samples of a signal from its lines, completely and within a band [Hz] only.
    fn samples(&self, at_0: Complex64, lines: impl Iterator<Item = Complex64>, band: [f64; 2]) -> [Vec<f64>; 2] {
        let length = self.inverse.length();
        let mut values = vec![ZERO; length];
        values[0] = at_0;
        for (k, value) in lines.enumerate() {
            let hz = (k + 1) as f64 * self.spacing();
            let inside = if (band[0]..=band[1]).contains(&hz) { value } else { ZERO };
            // Two real signals are the real and the imaginary part of one transform.
            let turned = |value: Complex64| Complex64::new(-value.im, value.re);
            values[k + 1] = value + turned(inside);
            values[length - k - 1] = value.conj() + turned(inside.conj());
        }
        self.inverse.inverse(&mut values);
        values.truncate(crate::whole(libm::ceil(self.samples as f64 * self.part)));
        [
            values.iter().map(|value| value.re * self.part).collect(),
            values.iter().map(|value| value.im * self.part).collect(),
        ]
    }

    /// A signal times a response at its lines.
    #[must_use]
    pub fn whole(&self, signal: usize, response: &[Complex64], at_0: f64) -> Vec<f64> {
        let [whole, _] = self.signal(signal, response, at_0, [0.0; 2]);
        whole
    }
}

/// The following error with stages, from that without: e + T sum(v - R v), where v is the velocity of the motor; both
/// sampled at T.
#[must_use]
pub fn following_error(error: &[f64], v_motor: &[f64], left: &[f64], cycle_time: f64) -> Vec<f64> {
    let mut sum = 0.0;
    let mut add = |((error, v), left): ((&f64, &f64), &f64)| {
        sum += cycle_time * (v - left);
        error + sum
    };
    error.iter().zip(v_motor).zip(left).map(&mut add).collect()
}
