//! The largest weight at one frequency: how far one part of the loop can grow before the loop comes too near to -1.

use crate::{Complex64, magnitude};
use portable::Extreme;

/// A loop at a frequency: 1 + L = `rest` + w `part`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// 1 + L without the part
    pub rest: Complex64,
    /// what weight 1 adds
    pub part: Complex64,
    /// two standard errors of P, divided by its magnitude: L is uncertain by as much
    pub uncertainty: f64,
}

/// The largest weight, up to `most`, with |rest + w part| >= distance + u w |part| for it and all smaller ones, u the uncertainty: only the part is
/// uncertain.
///
/// ```text
/// B = Re(rest part*) - distance u |part|    A = |part|^2 (1 - u^2)    c = |rest|^2 - distance^2    D = B^2 - A c
/// w = c/(-B + sqrt D) where D > 0 and (B < 0 or A < 0)
/// ```
///
/// The smaller root of a quadratic equation, without cancellation. 0 where the rest is too near to 0 itself.
#[must_use]
pub fn largest_within(line: &Line, distance: f64, most: f64) -> f64 {
    let Line { rest, part, uncertainty } = line;
    let c = rest.norm_sqr() - distance * distance;
    if c <= 0.0 {
        return 0.0;
    }
    let b = (rest * part.conj()).re - distance * uncertainty * magnitude(*part);
    let a = part.norm_sqr() * (1.0 - uncertainty * uncertainty);
    let discriminant = b * b - a * c;
    if b >= 0.0 && a >= 0.0 || discriminant <= 0.0 {
        return most;
    }
    (c / (discriminant.sqrt() - b)).smaller(most)
}

/// Steps of the search where the response is uncertain.
const STEPS: u32 = 200;
/// Of a weight.
const PRECISION: f64 = 1e-9;

impl Line {
    /// How far the loop stays from -1 with a weight, at the least.
    pub(crate) fn distance(&self, weight: f64) -> f64 {
        let distance = self.rest + self.part * weight;
        magnitude(distance) - self.uncertainty * magnitude(distance - 1.0)
    }

    /// The least weight, up to `most`, at which the distance is `distance`; `most` if there is none.
    ///
    /// Without uncertainty in closed form.
    pub(crate) fn largest_weight(&self, distance: f64, most: f64) -> f64 {
        if self.uncertainty > 0.0 {
            return self.uncertain(distance, most);
        }
        largest_within(self, distance, most)
    }

    /// The distance changes by at most (1 + uncertainty) |part| for a change of the weight by 1: steps that never pass the root.
    fn uncertain(&self, distance: f64, most: f64) -> f64 {
        let steepest = (1.0 + self.uncertainty) * magnitude(self.part);
        if steepest == 0.0 {
            return if self.distance(0.0) > distance { most } else { 0.0 };
        }
        let mut weight = 0.0;
        for _ in 0..STEPS {
            let step = (self.distance(weight) - distance) / steepest;
            if step <= PRECISION {
                break;
            }
            weight += step;
            if weight >= most {
                return most;
            }
        }
        weight
    }

    /// On which side of -1 the loop passes as the weight grows: its sign changes where a weight meets -1 itself.
    pub(crate) fn side(&self) -> f64 {
        (self.rest * self.part.conj()).im
    }

    /// The weight at which 1 + L comes nearest to 0.
    pub(crate) fn nearest(&self) -> f64 {
        -(self.rest * self.part.conj()).re / self.part.norm_sqr()
    }
}
