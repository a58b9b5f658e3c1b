//! The largest weight at one frequency: how far one part of the loop can grow until the loop is too close to -1.

use crate::{Complex64, magnitude};
use portable::Extreme;

/// A loop at a frequency: 1 + L = `rest` + w `part`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// 1 + L without the part
    pub rest: Complex64,
    /// the contribution of weight 1
    pub part: Complex64,
    /// two standard errors of P, divided by its magnitude: the relative uncertainty of L
    pub uncertainty: f64,
}

/// The largest weight, up to `most`, for which |rest + w part| >= distance + u w |part| holds for it and all smaller
/// weights; u is the uncertainty, and only the part is uncertain.
///
/// ```text
/// B = Re(rest part*) - distance u |part|    A = |part|^2 (1 - u^2)    c = |rest|^2 - distance^2    D = B^2 - A c
/// w = c/(-B + sqrt D) where D > 0 and (B < 0 or A < 0)
/// ```
///
/// The smaller root of a quadratic equation, without cancellation. 0 if the rest itself is too close to 0.
#[must_use]
pub fn largest_within(line: &Line, distance: f64, most: f64) -> f64 {
    within(line, distance, most).smaller(most)
}

/// [`largest_within`]; if it is `most`, `most` and the least value up to there of c + 2 B w + A w^2, which would be 0: a search
/// between two frequencies at which all weights are allowed then finds one between them at which they are not.
fn within(line: &Line, distance: f64, most: f64) -> f64 {
    let Line { rest, part, uncertainty } = line;
    let c = rest.norm_sqr() - distance * distance;
    if c <= 0.0 {
        return 0.0;
    }
    let b = (rest * part.conj()).re - distance * uncertainty * magnitude(*part);
    let a = part.norm_sqr() * (1.0 - uncertainty * uncertainty);
    let discriminant = b * b - a * c;
    if b >= 0.0 && a >= 0.0 {
        return most + c;
    }
    if discriminant > 0.0 {
        let weight = c / (discriminant.sqrt() - b);
        if weight < most {
            return weight;
        }
    }
    let nearest = if a > 0.0 { (-b / a).smaller(most) } else { most };
    most + (c + nearest * (2.0 * b + a * nearest)).larger(0.0)
}

/// Steps of the search if the response is uncertain.
const STEPS: u32 = 200;
/// Precision of a weight.
const PRECISION: f64 = 1e-9;

impl Line {
    /// 1 + L with a weight.
    pub(crate) fn at(&self, weight: f64) -> Complex64 {
        self.rest + self.part * weight
    }

    /// The least distance of the loop from -1 with a weight.
    pub(crate) fn distance(&self, weight: f64) -> f64 {
        let distance = self.at(weight);
        let uncertain = if self.uncertainty > 0.0 { self.uncertainty * magnitude(distance - 1.0) } else { 0.0 };
        magnitude(distance) - uncertain
    }

    /// The least weight, up to `most`, at which the distance is `distance`; if there is none, `most` and how far from it the
    /// loop stays.
    ///
    /// Without uncertainty in closed form.
    pub(crate) fn largest_weight(&self, distance: f64, most: f64) -> f64 {
        if self.uncertainty > 0.0 {
            return self.uncertain(distance, most);
        }
        within(self, distance, most)
    }

    /// A change of the weight by 1 changes the distance by at most (1 + uncertainty) |part|, so the steps never pass the
    /// root.
    fn uncertain(&self, distance: f64, most: f64) -> f64 {
        let steepest = (1.0 + self.uncertainty) * magnitude(self.part);
        if steepest == 0.0 {
            return if self.distance(0.0) > distance { most + self.distance(0.0) - distance } else { 0.0 };
        }
        let mut weight = 0.0;
        for _ in 0..STEPS {
            let step = (self.distance(weight) - distance) / steepest;
            if step <= PRECISION {
                break;
            }
            weight += step;
            if weight >= most {
                let nearest = self.nearest().larger(0.0).smaller(most);
                return most + (self.distance(nearest) - distance).larger(0.0);
            }
        }
        weight
    }

    /// The side of -1 on which the loop passes as the weight grows: the sign changes where a weight leads to -1 itself.
    pub(crate) fn side(&self) -> f64 {
        (self.rest * self.part.conj()).im
    }

    /// The weight at which 1 + L is closest to 0.
    pub(crate) fn nearest(&self) -> f64 {
        -(self.rest * self.part.conj()).re / self.part.norm_sqr()
    }
}
