//! Peaks of the spectrum while an axis drives: frequency, amplitude, doubtful peaks, steady lines. No damping: it comes from
//! a decay.

use crate::segments::{Kind, Segment, settled};
use crate::welch::hann;
use crate::{Complex64, fourier, magnitude, turned, whole};
use nalgebra::{Matrix3, Vector3};
use portable::Extreme;
use std::f64::consts::{LN_2, PI, SQRT_2, TAU};
use std::ops::Range;

/// Driving is examined from this time after a ramp [s].
const SETTLE: f64 = 0.3;
/// The shortest window that is used [s].
const SHORTEST: f64 = 0.25;
/// Windows are padded with zeros to at least this length.
const PADDED: usize = 1 << 14;
/// A peak is the largest line within this distance, in 1/(length of the window).
const RESOLVED: f64 = 2.0;
/// Minimum power of a peak relative to the median around it: 10 dB.
const ABOVE: f64 = 10.0;
/// Two peaks compete if the second has this part of the first one's power.
const COMPETES: f64 = 0.3;
/// A peak is at the edge within this number of lines, 1/(length of the window), of an end.
const EDGE: f64 = 3.0;
/// The factor of the frequency error of a Hann window relative to a rectangle: the square root of 2.34, from the moments of
/// both.
const OF_HANN: f64 = 1.53;
/// A line is steady if its amplitude in the second half of the windows is at least this part of that in the first half.
const STANDS: f64 = 0.8;

/// The mean of the spectra of some windows.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// distance of lines [Hz]
    pub spacing: f64,
    /// 1/(length of the shortest window) [Hz]
    pub resolution: f64,
    pub windows: usize,
    /// the square of the amplitude of a sine, line by line from 0 Hz
    pub power: Vec<f64>,
}

/// A peak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// [Hz], and its standard error
    pub hz: f64,
    pub hz_error: f64,
    /// amplitude of a sine, in the unit of the signal
    pub amplitude: f64,
    /// another peak has almost as much power: it is unknown which of the two matters
    pub competes: bool,
    /// it is so close to an end of the spectrum that its maximum may be outside
    pub is_at_edge: bool,
}

/// The windows in which an axis drives, from 0.3 s after a ramp.
#[must_use]
pub fn driving(segments: &[Segment], cycle_time: f64) -> Vec<Range<usize>> {
    let shortest = whole(SHORTEST / cycle_time);
    settled(segments, Kind::Driving, whole(SETTLE / cycle_time)).filter(|window| window.len() >= shortest).collect()
}

impl Spectrum {
    /// The spectrum of windows of a signal: a quadratic trend is removed, a Hann window is applied, zeros are added up to at
    /// least 2^14 samples. `None` if there is no window.
    #[must_use]
    pub fn of(signal: &[f64], windows: &[Range<usize>], cycle_time: f64) -> Option<Self> {
        let shortest = windows.iter().map(ExactSizeIterator::len).min()?;
        let longest = windows.iter().map(ExactSizeIterator::len).max()?;
        let length = longest.next_power_of_two().max(PADDED);
        let mut power = vec![0.0; length / 2 + 1];
        for window in windows {
            let windowed = windowed(signal.get(window.clone())?)?;
            // The mean of the window is 1/2: the amplitude of a sine is 2 |sum| / (length / 2).
            let scale = 4.0 / window.len() as f64;
            let padded: Vec<f64> = windowed.into_iter().chain(std::iter::repeat(0.0)).take(length).collect();
            for (power, line) in power.iter_mut().zip(fourier::of_real(&padded)) {
                *power += line.norm_sqr() * scale * scale / windows.len() as f64;
            }
        }
        Some(Self {
            spacing: 1.0 / (length as f64 * cycle_time),
            resolution: 1.0 / (shortest as f64 * cycle_time),
            windows: windows.len(),
            power,
        })
    }

    /// The peaks, the strongest first: the largest line within 2/(length of the window), 10 dB above the median of half an
    /// octave on each side beyond it; a parabola through ln(power) determines its place.
    #[must_use]
    pub fn peaks(&self) -> Vec<Peak> {
        let near = whole(RESOLVED * self.resolution / self.spacing).max(1);
        let last = self.power.len() - 1;
        let mut peaks = Vec::new();
        for k in near + 1..last.saturating_sub(near) {
            let is_largest = |other: usize| self.power[other] < self.power[k] || other == k;
            if !(k - near..=k + near).all(is_largest) {
                continue;
            }
            let [low, high] = [whole((k - near) as f64 / SQRT_2), whole((k + near) as f64 * SQRT_2).min(last)];
            let about = (low.max(1)..=high).filter(|other| other.abs_diff(k) > near).map(|other| self.power[other]);
            let mut about: Vec<f64> = about.collect();
            about.sort_by(f64::total_cmp);
            let Some(median) = about.get(about.len() / 2) else { continue };
            if self.power[k] > ABOVE * median {
                peaks.push(self.peak(k, *median));
            }
        }
        peaks.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
        if let [first, second, ..] = peaks.as_mut_slice()
            && second.amplitude * second.amplitude >= COMPETES * first.amplitude * first.amplitude
        {
            (first.competes, second.competes) = (true, true);
        }
        peaks
    }

    /// The strongest peak within a band [Hz].
    #[must_use]
    pub fn strongest(&self, band: [f64; 2]) -> Option<Peak> {
        self.peaks().into_iter().find(|peak| (band[0]..=band[1]).contains(&peak.hz))
    }

    /// The largest amplitude within a band [Hz], whether it is a peak or not.
    #[must_use]
    pub fn amplitude(&self, band: [f64; 2]) -> f64 {
        let inside = |(k, _): &(usize, &f64)| (band[0]..=band[1]).contains(&(*k as f64 * self.spacing));
        let power = self.power.iter().enumerate().filter(inside).fold(0.0, |largest: f64, (_, p)| largest.larger(*p));
        power.sqrt()
    }

    fn peak(&self, k: usize, median: f64) -> Peak {
        let [a, b, c] = [k - 1, k, k + 1].map(|k| libm::log(self.power[k].larger(f64::MIN_POSITIVE)));
        let bend = a - 2.0 * b + c;
        let place = if bend < 0.0 { 0.5 * (a - c) / bend } else { 0.0 };
        let hz = (k as f64 + place) * self.spacing;
        let power = libm::exp(b - 0.25 * (a - c) * place);
        // The least error of a sine in white noise with the mean power m of a line: sqrt(m / power) / (pi length). The
        // median of a power is ln 2 m.
        let mean = median / LN_2 / self.windows as f64;
        let end = (self.power.len() - 1) as f64 * self.spacing;
        Peak {
            hz,
            hz_error: OF_HANN * (mean / power).sqrt() * self.resolution / PI,
            amplitude: power.sqrt(),
            competes: false,
            is_at_edge: hz < EDGE * self.resolution || hz > end - EDGE * self.resolution,
        }
    }
}

/// Samples without their quadratic trend, with a Hann window; `None` if there are too few.
pub(crate) fn windowed(samples: &[f64]) -> Option<Vec<f64>> {
    let place = |n: usize| 2.0 * n as f64 / samples.len() as f64 - 1.0;
    let powers = |n: usize| Vector3::new(1.0, place(n), place(n) * place(n));
    let mut normal = Matrix3::zeros();
    let mut right = Vector3::zeros();
    for (n, sample) in samples.iter().enumerate() {
        let powers = powers(n);
        normal += Matrix3::from_fn(|i, j| powers[i] * powers[j]);
        right += powers * *sample;
    }
    let trend = normal.cholesky()?.solve(&right);
    let without = |(n, sample): (usize, &f64)| sample - trend.dot(&powers(n));
    Some(samples.iter().enumerate().map(without).zip(hann(samples.len())).map(|(value, hann)| value * hann).collect())
}

/// A windowed signal at one frequency [Hz]: twice the amplitude of a sine, with the phase at the beginning of the window.
pub(crate) fn at(windowed: &[f64], cycle_time: f64, hz: f64) -> Complex64 {
    let term = |(n, sample): (usize, &f64)| turned(-TAU * hz * cycle_time * n as f64) * sample;
    windowed.iter().enumerate().map(term).sum::<Complex64>() * (4.0 / windowed.len() as f64)
}

/// Whether a line is steady at constant speed: it is forced, and has no damping. Its amplitude in the second halves of the
/// windows is at least 0.8 of that in the first.
#[must_use]
pub fn stands(signal: &[f64], windows: &[Range<usize>], cycle_time: f64, hz: f64) -> bool {
    let mut halves = [0.0; 2];
    for window in windows {
        let middle = window.start.midpoint(window.end);
        for (sum, half) in halves.iter_mut().zip([window.start..middle, middle..window.end]) {
            let Some(windowed) = signal.get(half).and_then(windowed) else { return false };
            let size = magnitude(at(&windowed, cycle_time, hz));
            *sum += size * size;
        }
    }
    halves[1].sqrt() >= STANDS * halves[0].sqrt() && halves[0] > 0.0
}

/// Whether two lines at two speeds are the same order: the ratio of frequency and speed is equal, within two standard errors
/// and 1 %.
#[must_use]
pub fn is_order(lines: [[f64; 2]; 2], speeds: [f64; 2]) -> bool {
    let [a, b] = [0, 1].map(|i| lines[i][0] / libm::fabs(speeds[i]));
    let errors = [0, 1].map(|i| lines[i][1] / libm::fabs(speeds[i]));
    let error = (errors[0] * errors[0] + errors[1] * errors[1]).sqrt();
    let is_other_speed = libm::fabs(libm::fabs(speeds[0] / speeds[1]) - 1.0) > 0.05;
    is_other_speed && libm::fabs(a - b) <= 2.0 * error + 0.01 * a
}
