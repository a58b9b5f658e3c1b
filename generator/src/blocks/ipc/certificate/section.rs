//! Second-order sections as measured: a step, and bounds of all future steps. Nothing is measured here.

use super::free::{Denominator, Free};
use crate::design::response::at_dc_and_nyquist;
use crate::design::trapezoidal::Trapezoidal;
use portable::Extreme;

/// A section as measured.
#[derive(Clone, Copy)]
pub enum Section {
    Biquad(Biquad),
    Trapezoidal(Trapezoidal),
}

/// `y = s1 + b0 x; s1 = s2 - a1 s1 + from_x[0] x; s2 = from_x[1] x - a2 s1`, with the old values on the right. In terms of
/// the coefficients, `from_x` is `[b1 - a1 b0, b2 - a2 b0]`.
#[derive(Clone, Copy)]
pub struct Biquad {
    pub b0: f64,
    pub a1: f64,
    pub a2: f64,
    /// from the input to s1 and s2
    pub from_x: [f64; 2],
}

/// Bounds of the sums of all future magnitudes.
pub(super) struct Coming {
    /// of the output
    pub y: f64,
    /// of the two values of the state
    pub s: [f64; 2],
}

impl Section {
    pub(super) fn denominator(&self) -> Denominator {
        match self {
            Self::Biquad(Biquad { a1, a2, .. }) => {
                let [dc, nyquist] = at_dc_and_nyquist(1.0, *a1, *a2);
                Denominator { a1: *a1, a2: *a2, left: 1.0 - a2, dc, nyquist }
            }
            Self::Trapezoidal(Trapezoidal { a, b, c, .. }) => {
                let (left, dc, nyquist) = (b - a * c, 2.0 * a * c, 4.0 - 2.0 * b);
                Denominator { a1: (dc - nyquist) / 2.0, a2: 1.0 - left, left, dc, nyquist }
            }
        }
    }

    /// One step. The state is s1 and s2, or s1 and low.
    #[inline]
    pub fn step(&self, s: &mut [f64; 2], x: f64) -> f64 {
        match self {
            Self::Biquad(Biquad { b0, a1, a2, from_x }) => {
                let y = s[0] + b0 * x;
                *s = [s[1] + from_x[0] * x - a1 * s[0], from_x[1] * x - a2 * s[0]];
                y
            }
            Self::Trapezoidal(section) => section.step(s, x),
        }
    }

    /// The values in the block's memory after a step. A section driven by the change of its input holds p and the input, so
    /// that their sum bounds both.
    #[inline]
    pub(super) fn held(&self, s: [f64; 2], x: f64) -> [f64; 2] {
        [s[0].abs(), s[1].abs() + if self.is_by_change() { x.abs() } else { 0.0 }]
    }

    /// Bounds for a section without input, from a state, including the present values.
    pub(super) fn coming(&self, free: &Free, s: [f64; 2]) -> Coming {
        match self {
            Self::Biquad(Biquad { a2, .. }) => {
                let own = free.sum(s[0], s[1]);
                Coming { y: own, s: [own, s[1].abs() + a2.abs() * own] }
            }
            Self::Trapezoidal(section) => {
                let mut next = s;
                let now = section.step(&mut next, 0.0);
                let then = section.step(&mut next.clone(), 0.0);
                // Each value evolves like the s1 of a biquad.
                let sum = |now: f64, then: f64| free.sum(now, then + 2.0 * free.half * now);
                Coming { y: sum(now, then), s: [sum(s[0], next[0]), sum(s[1], next[1])] }
            }
        }
    }

    /// Bounds for inputs whose magnitudes sum up to 1.
    pub(super) fn driven(&self, free: &Free) -> Coming {
        match self {
            Self::Biquad(Biquad { b0, a2, from_x, .. }) => {
                let s1 = free.sum(from_x[0], from_x[1]);
                Coming { y: b0.abs() + s1, s: [s1, a2.abs() * s1 + from_x[1].abs()] }
            }
            Self::Trapezoidal(section) => {
                let mut s = [0.0; 2];
                let y = section.step(&mut s, 1.0);
                let Coming { y: later, s: [s1, low] } = self.coming(free, s);
                // After the end of the input, an all-pass and the oscillation output the decay of their band-pass part.
                Coming { y: y.abs() + later, s: [s1, low + if self.is_by_change() { 1.0 } else { 0.0 }] }
            }
        }
    }

    /// Bound of the sum of all effects of errors of 1 in both state values, in the units of the first.
    pub(super) fn sum_of_any(&self, free: &Free) -> f64 {
        match self {
            Self::Biquad(_) => free.sum_of_any(),
            Self::Trapezoidal(section) => {
                let scale = section.scale();
                let from = |s| {
                    let Coming { s: [s1, low], .. } = self.coming(free, s);
                    s1.larger(scale * low)
                };
                from([1.0, 0.0]) + from([0.0, 1.0 / scale])
            }
        }
    }

    fn is_by_change(&self) -> bool {
        matches!(self, Self::Trapezoidal(Trapezoidal { is_by_change: true, .. }))
    }
}
