//! The largest values inside a block, from the L1 norm: for |x| <= 1, |v| <= sum of |impulse response from x to v|.
//!
//! The first samples of each sum are added up, the rest is bounded by closed forms: a bound, never an estimate.

use super::chain::Chain;
use super::free::{self, Free};
use super::section::{Coming, Section};
use portable::Extreme;
use portable::RealKind;
use std::collections::BTreeMap;

/// Largest magnitudes for inputs within +-1; infinite if no bound is proven.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// of any state of a section
    pub state: f64,
    /// of the sum before the limit
    pub v_sum: f64,
}

/// Limit of samples times sections that are added up: some 50 us for any parameters.
pub const BUDGET: usize = 8_192;
/// Longest time constant for which samples are added up, as a part of the budget.
const LONG: f64 = 0.5;
/// Samples from one check of the rest to the next.
const BLOCK: usize = 64;
/// A rest below this part of the sum is small enough.
const SMALL: f64 = 1e-4;
/// A generous bound of this computation's own rounding errors.
const SLACK: f64 = 1e-6;

/// Bounds of the whole block.
///
/// A block starts in the steady state of its input. An input that was constant for ever leads to that state, so every bound
/// for all sequences of samples also holds from there.
pub fn bounds(chains: &[Chain], real: RealKind) -> Bound {
    let sections: usize = chains.iter().map(|chain| chain.section.len()).sum();
    let budget = BUDGET / sections.max(1);
    let runs: Vec<Run> = chains.iter().map(|chain| run(chain, budget, real)).collect();
    let mut of_input: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    for (chain, run) in chains.iter().zip(&runs) {
        let sum = of_input.entry(chain.input).or_default();
        sum.resize(sum.len().max(run.response.len()), 0.0);
        sum.iter_mut().zip(&run.response).for_each(|(sum, h)| *sum += h);
    }
    let certain = |rounding: f64| (1.0 + SLACK) * rounding;
    let summed = of_input.values().flatten().map(|h| h.abs()).sum::<f64>();
    let rest = runs.iter().map(|run| run.rest).sum::<f64>();
    let rounding = runs.iter().map(|run| run.rounding).fold(1.0, f64::larger);
    let state = runs.iter().map(|run| run.state * certain(run.rounding)).fold(0.0, f64::larger);
    Bound { state, v_sum: (summed + rest) * certain(rounding) }
}

/// The response of one stage to an impulse.
pub struct Run {
    /// v_stage, as far as it was added up
    pub response: Vec<f64>,
    /// bound of the sum of all |v_stage| after that
    rest: f64,
    /// bound of the L1 norm to any state
    state: f64,
    /// factor, at least 1, for the roundings of the block's own arithmetic
    rounding: f64,
}

/// Sums and bounds of one section.
struct Sums {
    section: Section,
    free: Free,
    /// bounds for inputs whose magnitudes sum up to 1
    driven: Coming,
    s: [f64; 2],
    sum: [f64; 2],
}

pub fn run(chain: &Chain, budget: usize, real: RealKind) -> Run {
    let sums = |section: &Section| {
        let free = free::bounds(&section.denominator());
        let driven = section.driven(&free);
        Sums { section: *section, free, driven, s: [0.0; 2], sum: [0.0; 2] }
    };
    let mut sections: Vec<Sums> = chain.section.iter().map(sums).collect();
    let slowest = sections.iter().map(|sums| sums.free.even).fold(0.0, f64::larger);
    let mut response = Vec::new();
    let mut total = 0.0;
    let mut after = rest(&sections, 1.0, chain.gain);
    // If the decay takes far longer than the budget, adding up a part of it gains nothing.
    if slowest < LONG * budget as f64 {
        while response.len() + BLOCK <= budget {
            let mut signal = [0.0; BLOCK];
            if response.is_empty() {
                signal[0] = 1.0;
            }
            sections.iter_mut().for_each(|sums| sums.run(&mut signal));
            signal.iter_mut().for_each(|y| *y *= chain.gain);
            total += signal.iter().map(|h| h.abs()).sum::<f64>();
            response.extend(signal);
            after = rest(&sections, 0.0, chain.gain);
            let so_far = sections.iter().flat_map(|sums| sums.sum).fold(0.0, f64::larger);
            if after.0 <= SMALL * total && after.1 - so_far <= SMALL * so_far {
                break;
            }
        }
    }
    let (rest, state) = after;
    Run { response, rest, state, rounding: rounding(&sections, real) }
}

/// Bounds for an input whose future |x| sum up to `x`: of the sum of all future |v_stage|, and of the largest sum of all
/// |state|.
fn rest(sections: &[Sums], mut x: f64, gain: f64) -> (f64, f64) {
    let mut state = 0.0_f64;
    for Sums { section, free, driven, s, sum } in sections {
        let own = section.coming(free, *s);
        for ((sum, own), driven) in sum.iter().zip(own.s).zip(driven.s) {
            state = state.larger(sum + own + driven * x);
        }
        x = own.y + driven.y * x;
    }
    (gain.abs() * x, state)
}

impl Sums {
    /// Runs the section on a signal, in place.
    fn run(&mut self, signal: &mut [f64; BLOCK]) {
        let Self { section, mut s, mut sum, .. } = *self;
        for x in signal {
            let held = section.held(s, *x);
            sum = [sum[0] + held[0], sum[1] + held[1]];
            *x = section.step(&mut s, *x);
        }
        (self.s, self.sum) = (s, sum);
    }
}

/// The effect of the block's roundings, as a factor.
///
/// A step of a section rounds about eight times, each by a unit roundoff u of a value that is at most a few times the
/// largest of its states: an error of at most e = 32 u max(|s1|, |s2|) in both states. Each error evolves like a state of
/// its own. With N = [`Free::sum_of_any`], all of them together add at most e N to the states; with the errors that these
/// cause in turn, the factor is 1 / (1 - 32 u N). If 32 u N is not small, no bound is proven.
fn rounding(sections: &[Sums], real: RealKind) -> f64 {
    let unit = if real == RealKind::F64 { f64::EPSILON } else { f32::EPSILON.into() } / 2.0;
    let factor = |sums: &Sums| {
        let part = 32.0 * unit * sums.section.sum_of_any(&sums.free);
        if part < 0.5 { 1.0 / (1.0 - part) } else { f64::INFINITY }
    };
    sections.iter().map(factor).product()
}
