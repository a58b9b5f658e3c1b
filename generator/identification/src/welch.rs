//! Spectra of two signals without a period: means over overlapping segments under Hann windows. Nothing is judged.

use crate::{Complex64, ZERO, fourier};
use portable::Extreme;
use std::f64::consts::TAU;

/// Spectra of x and y by line k/(length T); the line at 0 Hz has no meaning.
pub(crate) struct Spectra {
    /// samples of a segment
    pub length: usize,
    pub xx: Vec<f64>,
    pub yy: Vec<f64>,
    /// sum of X* Y
    pub xy: Vec<Complex64>,
}

/// The Hann window of that length: 0 at its first sample, mean 1/2.
pub(crate) fn hann(length: usize) -> impl Iterator<Item = f64> {
    (0..length).map(move |n| 0.5 - 0.5 * libm::cos(TAU * n as f64 / length as f64))
}

impl Spectra {
    /// The spectra over segments that overlap by half, each without its mean; `None` if the signals are shorter than one
    /// segment.
    pub(crate) fn of(x: &[f64], y: &[f64], length: usize) -> Option<Self> {
        let common = x.len().min(y.len());
        (length > 1 && common >= length).then_some(())?;
        let window: Vec<f64> = hann(length).collect();
        let lines = length / 2 + 1;
        let (mut xx, mut yy, mut xy) = (vec![0.0; lines], vec![0.0; lines], vec![ZERO; lines]);
        for start in (0..common - length + 1).step_by(length / 2) {
            let transform = |of: &[f64]| {
                let part = &of[start..start + length];
                let mean = part.iter().sum::<f64>() / length as f64;
                fourier::of_real(&part.iter().zip(&window).map(|(v, w)| (v - mean) * w).collect::<Vec<_>>())
            };
            let (a, b) = (transform(x), transform(y));
            for k in 0..lines {
                xx[k] += a[k].norm_sqr();
                yy[k] += b[k].norm_sqr();
                xy[k] += a[k].conj() * b[k];
            }
        }
        Some(Self { length, xx, yy, xy })
    }

    /// |S_xy|^2 / (S_xx S_yy), from 0 to 1.
    pub(crate) fn coherence(&self, k: usize) -> f64 {
        let power = self.xx[k] * self.yy[k];
        if power > 0.0 { (self.xy[k].norm_sqr() / power).smaller(1.0) } else { 0.0 }
    }
}
