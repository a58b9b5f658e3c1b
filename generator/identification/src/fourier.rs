//! Discrete Fourier transforms of any length. No window, no physical unit.
//!
//! Existing libraries take their sines from the host, whose last bit differs from system to system; here they come from
//! libm.

use crate::{Complex64, ZERO, turned};
use std::f64::consts::{PI, TAU};

/// A transform whose length is a power of two.
pub(crate) struct Fourier {
    /// exp(-j 2 pi k / n) for k < n/2
    turns: Vec<Complex64>,
    length: usize,
}

impl Fourier {
    /// A transform of at least that length.
    pub(crate) fn at_least(length: usize) -> Self {
        let length = length.next_power_of_two().max(2);
        let turns = (0..length / 2).map(|k| turned(-TAU * k as f64 / length as f64)).collect();
        Self { turns, length }
    }

    pub(crate) fn length(&self) -> usize {
        self.length
    }

    /// X_k = sum of x_n exp(-j 2 pi k n / N), in place: decimation in time.
    pub(crate) fn forward(&self, values: &mut [Complex64]) {
        let bits = self.length.trailing_zeros();
        for from in 0..self.length {
            let to = from.reverse_bits() >> (usize::BITS - bits);
            if from < to {
                values.swap(from, to);
            }
        }
        let mut half = 1;
        while half < self.length {
            let stride = self.length / (2 * half);
            for block in values.chunks_exact_mut(2 * half) {
                let (low, high) = block.split_at_mut(half);
                for ((a, b), turn) in low.iter_mut().zip(high).zip(self.turns.iter().step_by(stride)) {
                    let product = *b * turn;
                    (*a, *b) = (*a + product, *a - product);
                }
            }
            half *= 2;
        }
    }

    /// x_n = 1/N sum of X_k exp(j 2 pi k n / N), in place.
    pub(crate) fn inverse(&self, values: &mut [Complex64]) {
        self.forward(values);
        values[1..].reverse();
        let part = 1.0 / self.length as f64;
        values.iter_mut().for_each(|value| *value *= part);
    }
}

/// X_k for k = 0..N of complex samples of any number N: Bluestein's convolution with a chirp.
pub(crate) fn of(samples: &[Complex64]) -> Vec<Complex64> {
    let n = samples.len();
    if n.is_power_of_two() && n > 1 {
        let mut values = samples.to_vec();
        Fourier::at_least(n).forward(&mut values);
        return values;
    }
    // exp(-j pi k^2 / N): the square is taken modulo 2 N, so that no digit of the angle is lost.
    let chirp: Vec<Complex64> = (0..n).map(|k| turned(-PI * (k * k % (2 * n)) as f64 / n as f64)).collect();
    let fourier = Fourier::at_least(2 * n);
    let mut signal = vec![ZERO; fourier.length()];
    let mut filter = signal.clone();
    for (k, (sample, chirp)) in samples.iter().zip(&chirp).enumerate() {
        signal[k] = sample * chirp;
        filter[k] = chirp.conj();
        if k > 0 {
            filter[fourier.length() - k] = chirp.conj();
        }
    }
    fourier.forward(&mut signal);
    fourier.forward(&mut filter);
    signal.iter_mut().zip(&filter).for_each(|(a, b)| *a *= b);
    fourier.inverse(&mut signal);
    signal.iter().zip(&chirp).map(|(value, chirp)| value * chirp).collect()
}

/// X_k for k = 0..=N/2 of real samples.
pub(crate) fn of_real(samples: &[f64]) -> Vec<Complex64> {
    let mut lines = of(&samples.iter().map(|x| Complex64::from(*x)).collect::<Vec<_>>());
    lines.truncate(samples.len() / 2 + 1);
    lines
}

/// The N real samples with these lines X_k, k = 0..=N/2.
pub(crate) fn real_of(lines: &[Complex64], length: usize) -> Vec<f64> {
    // The forward transform of the conjugate is the conjugate of the inverse transform.
    let line = |k: usize| if 2 * k <= length { lines[k].conj() } else { lines[length - k] };
    let all: Vec<Complex64> = (0..length).map(line).collect();
    of(&all).iter().map(|value| value.re / length as f64).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transform_is_its_sum_at_any_length() {
        for n in [1_usize, 2, 7, 12, 64, 89, 178] {
            let samples: Vec<f64> = (0..n).map(|k| ((k * k * 7 + 3 * k) % 31) as f64 - 15.0).collect();
            let lines = of_real(&samples);
            for (k, line) in lines.iter().enumerate() {
                let term = |(m, x): (usize, &f64)| turned(-TAU * (k * m % n) as f64 / n as f64) * x;
                let sum: Complex64 = samples.iter().enumerate().map(term).sum();
                assert!((line - sum).norm_sqr() < 1e-20 * (1.0 + sum.norm_sqr()), "{n}, line {k}: {line} {sum}");
            }
            let back = real_of(&lines, n);
            assert!(back.iter().zip(&samples).all(|(a, b)| (a - b).abs() < 1e-11), "{n}: {back:?}");
        }
    }
}
