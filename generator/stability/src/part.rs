//! A loop with a part of it that grows: its turns around -1, where the part leads it there, its least distance.

use crate::crossing::Line;
use crate::driven::{At, Driven};
use crate::frequency::Point;
use crate::search::{least, root};
use portable::Extreme;

/// Halvings of an interval in which 1 + L changes by more than a quarter turn.
const DEPTH: u32 = 40;
/// A local minimum within this factor of the least one may be the least one between the points: where two stages and the
/// position controller interact, a point exceeded the minimum next to it by a half.
const NEAR: f64 = 4.0;
/// If all weights are allowed at a point, but nearly not ([`Line::largest_weight`]), some may not be allowed next to it.
const NEARLY: f64 = 0.2;

/// A loop at its points and between them, as a function of the weight of a part.
pub(crate) struct Part<'l, F> {
    driven: &'l Driven<'l>,
    line: F,
    /// the loop at its points: every question begins with them
    lines: Vec<Line>,
}

impl<'l, F: Fn(&At) -> Line> Part<'l, F> {
    pub(crate) fn new(driven: &'l Driven<'l>, line: F) -> Self {
        let lines = driven.all().map(|at| line(&at)).collect();
        Self { driven, line, lines }
    }

    /// Whether 1 + L with a weight of the part makes no turn around 0, from 0 Hz to half the sampling frequency. A position
    /// controller has its pole at 0 Hz; the path around it begins on the right.
    pub(crate) fn is_stable(&self, weight: f64) -> bool {
        let mut points = self.driven.points.iter().zip(&self.lines);
        let Some(mut last) = points.next() else { return true };
        let mut turns = 0;
        for next in points {
            turns += self.turns(weight, last, next, DEPTH);
            last = next;
        }
        turns == 0 && last.1.at(weight).re > 0.0
    }

    /// How often 1 + L passes the negative real axis from one point to the next, counterclockwise.
    fn turns(&self, weight: f64, a: (&Point, &Line), b: (&Point, &Line), depth: u32) -> i32 {
        let [from, to] = [a.1.at(weight), b.1.at(weight)];
        let turn = to * from.conj();
        if turn.re < 0.0 && depth > 0 {
            let middle = self.driven.middle(a.0, b.0);
            let middle = (&middle.0, &(self.line)(&middle));
            return self.turns(weight, a, middle, depth - 1) + self.turns(weight, middle, b, depth - 1);
        }
        match (from.im < 0.0, to.im < 0.0) {
            (false, true) if turn.im > 0.0 => 1,
            (true, false) if turn.im < 0.0 => -1,
            _ => 0,
        }
    }

    /// The largest |S| with a weight of the part, and its t; `None` if the loop is unstable.
    pub(crate) fn ms(&self, weight: f64) -> Option<[f64; 2]> {
        let (distance, t) = self.least(|line| line.distance(weight), |value, found| value <= found * NEAR);
        (distance > 0.0 && self.is_stable(weight)).then(|| [1.0 / distance, t])
    }

    /// The largest weight, above `least` and up to `most`, up to which a loop stays stable that is stable with `least`.
    pub(crate) fn largest_stable(&self, [least, most]: [f64; 2]) -> f64 {
        let mut largest = most;
        self.crossings(Line::side, |line| {
            let nearest = line.nearest();
            if nearest > least {
                largest = largest.smaller(nearest);
            }
        });
        if self.driven.is_uncertain() {
            largest = largest.smaller(self.largest_within(0.0, most));
        }
        largest
    }

    /// The largest weight, up to `most`, for which the distance is `distance` or more for it and all smaller weights.
    pub(crate) fn largest_within(&self, distance: f64, most: f64) -> f64 {
        let is_near = |value: f64, found: f64| value <= if value < most { found * NEAR } else { most + NEARLY };
        self.least(|line| line.largest_weight(distance, most), is_near).0.smaller(most)
    }

    /// The least value over all frequencies, and its t: at the points, then between the neighbours of those that are near the
    /// least one, which may be the least one between the points.
    fn least(&self, of: impl Fn(&Line) -> f64, is_near: impl Fn(f64, f64) -> bool) -> (f64, f64) {
        let values: Vec<f64> = self.lines.iter().map(&of).collect();
        let t = |k: usize| self.driven.points[k].t;
        let (mut found, mut at) = (f64::INFINITY, t(0));
        for (k, value) in values.iter().enumerate() {
            if *value < found {
                (found, at) = (*value, t(k));
            }
        }
        let least_point = found;
        for (k, window) in values.windows(3).enumerate() {
            let is_least = window[1] <= window[0] && window[1] <= window[2] && window[1] < window[0].larger(window[2]);
            if is_least && is_near(window[1], least_point) {
                let (t, value) = least(t(k), t(k + 2), |t| of(&self.at(t)));
                if value < found {
                    (found, at) = (value, t);
                }
            }
        }
        (found, at)
    }

    /// Calls `found` at each sign change of a function of the frequency.
    pub(crate) fn crossings(&self, of: impl Fn(&Line) -> f64, mut found: impl FnMut(Line)) {
        let mut last: Option<(f64, f64)> = None;
        for (Point { t, .. }, line) in self.driven.points.iter().zip(&self.lines) {
            let value = of(line);
            if let Some((from, before)) = last.filter(|(_, before)| (*before < 0.0) != (value < 0.0)) {
                found(self.at(root([from, *t], [before, value], |t| of(&self.at(t)))));
            }
            last = Some((*t, value));
        }
    }

    fn at(&self, t: f64) -> Line {
        (self.line)(&self.driven.at_t(t))
    }
}
