//! The search for shapes and weights that leave the least vibration: starts, then a compass search. Proposals are in
//! `proposals`.

use crate::angle;
use crate::figures::{Judge, Left};
use crate::scenarios::{Scenarios, most};
use crate::shape::{DAMPING, Mode, Q, Shape, Stages, allpass, highest};
use portable::Extreme;

/// Starts: factors of f0, quality factors, dampings, and logarithms of the ratios of weights.
const F0: [f64; 2] = [1.0, 0.95];
const Q_DIRECT: [f64; 2] = [3.0, 10.0];
const Q_INDIRECT: [f64; 3] = [2.0, 5.0, 10.0];
const DAMPINGS: [f64; 2] = [0.5, 0.8];
const RATIOS: [f64; 3] = [0.0, -0.7, 0.7];
/// Steps of ln f0 (DIRECT, INDIRECT), ln Q, D, ln of a ratio, ln of the used part.
const STEP_F0: [f64; 2] = [0.04, 0.08];
const STEP_Q: f64 = 0.5;
const STEP_DAMPING: f64 = 0.2;
const STEP_RATIO: f64 = 0.5;
const STEP_USED: f64 = 0.3;
/// The steps are halved down to this part.
const SMALLEST: f64 = 0.02;
/// Number of starts from which the search continues.
const BEST: usize = 3;
/// Largest relative distance of f0 from the vibration.
const FARTHEST: f64 = 0.25;
/// Lags of P from which an all-pass is tried, and from which it is required [degrees].
const TRIED: f64 = 20.0;
pub(crate) const MANDATORY: f64 = 90.0;
/// The factor of Ms in the cost.
const OF_MS: f64 = 0.1;
/// The factor of what the load moves too much after stops: more than any gain elsewhere.
const OF_UNSETTLED: f64 = 10.0;
/// The largest number of starts with the same modes; above it ratios are left out, then dampings.
const MOST_STARTS: usize = 150;

/// A candidate: one stage per vibration.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// f0, Q and damping of each stage; all-passes follow from f0
    pub shapes: Vec<Shape>,
    /// whether each stage has an all-pass
    pub turned: Vec<bool>,
    /// ln of each weight divided by the first one
    pub ratios: Vec<f64>,
    /// ln of the used part of the largest weights
    pub used: f64,
}

/// A candidate with its evaluation.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    pub candidate: Candidate,
    /// its stages with weights
    pub stages: Vec<(Shape, f64)>,
    pub left: Left,
    /// the lower, the better
    pub cost: f64,
}

/// The data for evaluating candidates.
pub struct Search<'a, 's> {
    pub scenarios: &'a Scenarios,
    pub judge: &'a Judge<'a>,
    pub stages: &'a Stages<'s>,
    pub cycle_time: f64,
    /// the largest |S| of each scenario
    pub limits: [f64; 4],
    /// [Hz]
    pub vibrations: Vec<f64>,
}

impl Search<'_, '_> {
    /// The lag of P at a frequency [Hz], in degrees from -90 to 270: a negative lag is a lead, as near an antiresonance.
    #[must_use]
    pub fn lag(&self, hz: f64) -> f64 {
        let degrees = -angle(self.scenarios.drives[0].value(hz)).to_degrees();
        if degrees < -90.0 { degrees + 360.0 } else { degrees }
    }

    /// The weights that the scenarios allow, the remaining vibration, and the cost: J = max(r, ring) + mean(r, ring) + 0.1
    /// Ms + 10 max(0, settled - 1.1). `None` if a required all-pass is impossible, or if no weight is allowed.
    #[must_use]
    pub fn judged(&self, candidate: &Candidate) -> Option<Judged> {
        let mut of = Vec::new();
        for ((shape, turned), ratio) in candidate.shapes.iter().zip(&candidate.turned).zip(&candidate.ratios) {
            let lag = self.lag(shape.f0);
            let allpass = if *turned { Some(allpass(shape.f0, lag, self.cycle_time)?) } else { None };
            (*turned || lag <= MANDATORY).then_some(())?;
            of.push((Shape { allpass, ..*shape }, libm::exp(*ratio)));
        }
        let controller = self.scenarios.controller(self.stages, &of);
        let largest = self.scenarios.largest_factor(&controller, self.limits, most(&of));
        let factor = largest * libm::exp(candidate.used);
        (factor > 0.0).then_some(())?;
        of.iter_mut().for_each(|(_, weight)| *weight *= factor);
        let left = self.judge.left(self.stages, &of);
        let [worst, mean] = left.worst_and_mean();
        let ms = self.scenarios.ms(&controller, factor)[0];
        let cost = worst + mean + OF_MS * ms + OF_UNSETTLED * left.unsettled();
        cost.is_finite().then(|| Judged { candidate: candidate.clone(), stages: of, left, cost })
    }

    /// The best candidate for any of these modes, one mode per vibration.
    #[must_use]
    pub fn best(&self, modes: &[Vec<Mode>]) -> Option<Judged> {
        let starts = modes.iter().flat_map(|modes| self.starts(modes));
        let mut starts: Vec<Judged> = starts.filter_map(|start| self.judged(&start)).collect();
        // A stable sort: of two equal starts the first one stays first.
        starts.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        let mut chosen: Vec<Judged> = Vec::new();
        for start in starts {
            if chosen.len() < BEST && chosen.iter().all(|other| differ(&other.candidate, &start.candidate)) {
                chosen.push(start);
            }
        }
        let found = chosen.into_iter().map(|start| self.descend(start)).reduce(better)?;
        Some(self.with_allpasses(found))
    }

    /// Tries an all-pass in each stage where P lags, and removing it where it is not required.
    fn with_allpasses(&self, mut found: Judged) -> Judged {
        for stage in 0..found.candidate.shapes.len() {
            let lag = self.lag(found.candidate.shapes[stage].f0);
            if !(TRIED..=MANDATORY).contains(&lag) {
                continue;
            }
            let mut other = found.candidate.clone();
            other.turned[stage] = !other.turned[stage];
            if let Some(other) = self.judged(&other) {
                found = better(found, self.descend(other));
            }
        }
        found
    }

    /// All combinations of shapes and ratios.
    fn starts(&self, modes: &[Mode]) -> Vec<Candidate> {
        let mut found = Vec::new();
        for simpler in 0..3 {
            found = self.combinations(modes, simpler);
            if found.len() <= MOST_STARTS {
                break;
            }
        }
        found
    }

    fn combinations(&self, modes: &[Mode], simpler: usize) -> Vec<Candidate> {
        let none = Candidate { shapes: Vec::new(), turned: Vec::new(), ratios: Vec::new(), used: 0.0 };
        let ratios = if simpler > 0 { &RATIOS[..1] } else { &RATIOS[..] };
        let mut candidates = vec![none];
        for (mode, hz) in modes.iter().zip(&self.vibrations) {
            let shapes: Vec<Shape> = shapes(*mode, *hz, simpler > 1);
            let turned = self.lag(*hz) > MANDATORY;
            let longer = |candidate: &Candidate| {
                let is_first = candidate.shapes.is_empty();
                let ratios = if is_first { &RATIOS[..1] } else { ratios };
                let mut longer = Vec::new();
                for shape in &shapes {
                    for ratio in ratios {
                        let mut next = candidate.clone();
                        next.shapes.push(*shape);
                        next.turned.push(turned);
                        next.ratios.push(*ratio);
                        longer.push(next);
                    }
                }
                longer
            };
            candidates = candidates.iter().flat_map(longer).collect();
        }
        candidates
    }

    /// A compass search: one step along each variable in both directions; the first improvement is taken. Steps are halved
    /// if there is none.
    fn descend(&self, mut best: Judged) -> Judged {
        let mut part = 1.0;
        while part >= SMALLEST {
            let mut is_better = false;
            for variable in 0..variables(&best.candidate) {
                for sign in [part, -part] {
                    let next = self.moved(&best.candidate, variable, sign).and_then(|next| self.judged(&next));
                    if let Some(next) = next.filter(|next| next.cost < best.cost) {
                        best = next;
                        is_better = true;
                        break;
                    }
                }
            }
            if !is_better {
                part /= 2.0;
            }
        }
        best
    }

    /// A candidate with one variable changed; `None` if it cannot be changed there.
    fn moved(&self, of: &Candidate, variable: usize, part: f64) -> Option<Candidate> {
        let mut next = of.clone();
        let stages = of.shapes.len();
        if let Some(shape) = next.shapes.get_mut(variable / 3) {
            let hz = self.vibrations[variable / 3];
            match (variable % 3, shape.mode) {
                (0, mode) => {
                    let step = STEP_F0[usize::from(mode == Mode::Indirect)] * part;
                    let highest = (hz * (1.0 + FARTHEST)).smaller(highest(self.cycle_time));
                    shape.f0 = within(shape.f0 * libm::exp(step), [hz * (1.0 - FARTHEST), highest]);
                }
                (1, _) => shape.q = within(shape.q * libm::exp(STEP_Q * part), Q),
                (_, Mode::Indirect) => shape.damping = within(shape.damping + STEP_DAMPING * part, DAMPING),
                (_, Mode::Direct) => return None,
            }
        } else if let Some(ratio) = next.ratios.get_mut(variable - 3 * stages + 1) {
            *ratio += STEP_RATIO * part;
        } else {
            next.used = (next.used + STEP_USED * part).smaller(0.0);
        }
        (next != *of).then_some(next)
    }
}

/// The number of variables: f0, Q and damping of each stage, the ratios, the used part.
fn variables(of: &Candidate) -> usize {
    4 * of.shapes.len()
}

fn within(value: f64, [low, high]: [f64; 2]) -> f64 {
    value.larger(low).smaller(high)
}

/// The better of the two; the first one if they are equal.
pub(crate) fn better(a: Judged, b: Judged) -> Judged {
    if b.cost < a.cost { b } else { a }
}

/// Whether the shapes of an INDIRECT stage differ between two starts; without INDIRECT stages, those of any stage.
fn differ(a: &Candidate, b: &Candidate) -> bool {
    let is_indirect = |candidate: &Candidate| candidate.shapes.iter().any(|shape| shape.mode == Mode::Indirect);
    let counts = |shape: &&Shape| !is_indirect(a) || shape.mode == Mode::Indirect;
    !a.shapes.iter().filter(counts).eq(b.shapes.iter().filter(counts))
}

/// The start shapes of a stage.
fn shapes(mode: Mode, hz: f64, is_simple: bool) -> Vec<Shape> {
    let mut shapes = Vec::new();
    let (parts, qs, dampings): (&[f64], &[f64], &[f64]) = match mode {
        Mode::Direct => (&F0[..1], &Q_DIRECT, &DAMPINGS[1..]),
        Mode::Indirect if is_simple => (&F0[..1], &Q_INDIRECT[..2], &DAMPINGS[1..]),
        Mode::Indirect => (&F0, &Q_INDIRECT, &DAMPINGS),
    };
    for part in parts {
        for q in qs {
            for damping in dampings {
                shapes.push(Shape { mode, f0: hz * part, q: *q, damping: *damping, allpass: None });
            }
        }
    }
    shapes
}
