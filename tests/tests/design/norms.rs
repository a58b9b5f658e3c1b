//! The norms of filters, and with them the largest sum that is not a fault, against impulse responses.

use super::{CYCLES, evenly, inputs};
use axgen_tests::environment::by_depth;
use axgen_tests::random::rng::Rng;
use rayon::prelude::*;
use reference::design::inputs::{FilterInputs, Inputs};
use reference::design::limit::{norm, sum_limit};
use reference::design::poles::Prototype;
use reference::design::{band, stage};
use reference::filter::{self, Type};
use reference::stage::{Coeffs, FILTERS, Mode, Numbers};
use reference::{allpass, bandpass, oscillation};

const PROTOTYPES: [Prototype; 3] = [Prototype::CritDamping, Prototype::Butterworth, Prototype::Bessel];
/// A response is added up until the last part of it is below this part of the sum.
const LEFT: f64 = 1e-6;
/// The lowest f0 Ts: below it the response of a filter is the same, stretched.
const LOWEST: f64 = 1e-3;

/// y = b0 x + b1 x' + b2 x'' - a1 y' - a2 y'', in direct form.
struct Section {
    b: [f64; 3],
    a: [f64; 2],
    x: [f64; 2],
    y: [f64; 2],
}

impl Section {
    fn new(b: [f64; 3], a: [f64; 2]) -> Self {
        Self { b, a, x: [0.0; 2], y: [0.0; 2] }
    }

    fn bandpass(of: &bandpass::Coeffs<f64>) -> Self {
        Self::new([-of.b2, 0.0, of.b2], [of.a1, of.a2])
    }

    fn allpass(of: &allpass::Coeffs<f64>) -> Self {
        Self::new([of.a2, of.a1, 1.0], [of.a1, of.a2])
    }

    fn oscillation(of: &oscillation::Coeffs<f64>) -> Self {
        Self::new([of.b0, of.b1, of.b2], [of.a1, of.a2])
    }

    fn run(&mut self, x: f64) -> f64 {
        let Self { b, a, x: [x1, x2], y: [y1, y2] } = self;
        let y = b[0] * x + b[1] * *x1 + b[2] * *x2 - a[0] * *y1 - a[1] * *y2;
        (*x2, *x1, *y2, *y1) = (*x1, x, *y1, y);
        y
    }

    /// Cycles in which its free vibration decays by e.
    fn decay(&self) -> f64 {
        let [half, product] = [self.a[0] / 2.0, self.a[1]];
        let square = half * half - product;
        let pole = if square < 0.0 { product.sqrt() } else { half.abs() + square.sqrt() };
        1.0 / (1.0 - pole)
    }
}

/// A stage of weight 1.
#[derive(Debug)]
struct Case {
    structure: Coeffs<f64>,
    prototypes: [Prototype; FILTERS],
    inputs: Inputs<f64>,
    cycle_time_ns: u32,
}

impl Case {
    /// In 1 ms.
    fn new(mode: Mode, kinds: [Type; FILTERS]) -> Self {
        let filter = kinds.map(|kind| filter::Coeffs { kind, order: 1, ..filter::Coeffs::default() });
        let inputs = Inputs { weight: 1.0, ..Inputs::default() };
        let structure = Coeffs { mode, filter, ..Coeffs::default() };
        Self { structure, prototypes: [Prototype::default(); FILTERS], inputs, cycle_time_ns: 1_000_000 }
    }

    fn sections(&self) -> Vec<Section> {
        let (mut numbers, cycle_time) = (Numbers::default(), band::cycle_time(self.cycle_time_ns));
        stage::design(&mut numbers, &self.structure, &self.prototypes, &self.inputs, cycle_time);
        let is_simulated = self.structure.mode != Mode::Direct;
        let mut sections: Vec<_> =
            is_simulated.then(|| Section::oscillation(&numbers.oscillation)).into_iter().collect();
        for (of, numbers) in self.structure.filter.iter().zip(&numbers.filter) {
            match of.kind {
                Type::NoFilter => {}
                Type::Bandpass => sections.extend(numbers.bandpass[..of.order].iter().map(Section::bandpass)),
                Type::Allpass => sections.push(Section::allpass(&numbers.allpass)),
            }
        }
        sections
    }

    /// Tests that the norm is a bound of the response of these sections; returns how many times it is above.
    fn above(&self, mut sections: Vec<Section>) -> f64 {
        let slowest = sections.iter().map(Section::decay).fold(8.0, f64::max);
        let (mut sum, mut before, mut x) = (0.0, -1.0, 1.0);
        while sum - before > LEFT * sum {
            before = sum;
            for _ in 0..(2.0 * slowest) as usize {
                sum += sections.iter_mut().fold(x, |x, section| section.run(x)).abs();
                x = 0.0;
            }
        }
        let bound = norm(&self.structure, &self.inputs);
        assert!(sum <= bound, "{sum} above the bound {bound}: {self:?}");
        bound / sum
    }
}

/// Steps from the first to the last number, evenly in the logarithm.
fn grid(first: f64, last: f64) -> impl ParallelIterator<Item = f64> {
    let count = by_depth(60, 100, 300);
    (0..=count).into_par_iter().map(move |i| first * libm::pow(last / first, i as f64 / count as f64))
}

/// The largest distance of bound and response for all f0 Ts and the second input from the first to the last.
fn widest(first: f64, last: f64, above: impl Fn(f64, f64) -> f64 + Sync) -> f64 {
    let of_share = |share: f64| grid(first, last).map(|second| above(share, second)).reduce(|| 0.0, f64::max);
    // to 0.45 exactly
    grid(0.45, LOWEST).map(of_share).reduce(|| 0.0, f64::max)
}

#[test]
fn the_norm_of_a_band_pass_holds() {
    for prototype in PROTOTYPES {
        for order in 1..=3 {
            let widest = widest(1.0, 10.0, |share, q_factor| {
                let mut case = Case::new(Mode::Direct, [Type::Bandpass, Type::NoFilter]);
                (case.structure.filter[0].order, case.prototypes[0]) = (order, prototype);
                case.inputs.filter[0] = FilterInputs { f0: share * 1e3, q_factor };
                case.above(case.sections())
            });
            assert!(widest < 4.01, "{widest} times above: {prototype:?} {order}");
        }
    }
}

#[test]
fn the_norm_of_an_all_pass_holds() {
    let widest = widest(1.0, 10.0, |share, q_factor| {
        let mut case = Case::new(Mode::Direct, [Type::Allpass, Type::NoFilter]);
        case.inputs.filter[0] = FilterInputs { f0: share * 1e3, q_factor };
        case.above(case.sections())
    });
    assert!(widest < 4.51, "{widest} times above");
}

/// Alone: without the band-pass whose centre it has.
#[test]
fn the_norm_of_the_oscillation_holds() {
    let widest = widest(1e-3, 0.9999, |share, damping| {
        let mut case = Case::new(Mode::Indirect, [Type::Bandpass, Type::NoFilter]);
        case.inputs.filter[0] = FilterInputs { f0: share * 1e3, q_factor: 1.0 };
        case.inputs.damping = damping;
        let oscillation = case.sections().remove(0);
        case.structure.filter[0].kind = Type::NoFilter;
        case.above(vec![oscillation])
    });
    assert!(widest < 1.7, "{widest} times above");
}

/// In two bands a stage may pass almost nothing, so that the norm may be any factor above.
#[test]
fn the_norm_of_a_stage_holds() {
    let widest = (0..by_depth(2_000, 10_000, 100_000)).into_par_iter().map(|index| {
        let mut rng = Rng::numbered(0x006e_6f72_6d00, index);
        let kinds = [[Type::Bandpass, Type::NoFilter], [Type::Bandpass; 2], [Type::Allpass, Type::Bandpass]];
        let mut case = Case::new(*rng.pick(&[Mode::Direct, Mode::Indirect]), *rng.pick(&kinds));
        case.cycle_time_ns = *rng.pick(&CYCLES);
        case.inputs.filter = inputs(&mut rng, case.cycle_time_ns).filter;
        for k in 0..FILTERS {
            (case.structure.filter[k].order, case.prototypes[k]) = (rng.below(3) + 1, *rng.pick(&PROTOTYPES));
            let f0 = &mut case.inputs.filter[k].f0;
            *f0 = f0.max(LOWEST * 1e9 / f64::from(case.cycle_time_ns));
        }
        case.inputs.damping = evenly(&mut rng, 0.01, 0.999);
        let has_one_band = index % 2 == 0;
        if has_one_band {
            case.inputs.filter[1] = case.inputs.filter[0];
        }
        let above = case.above(case.sections());
        if has_one_band { above } else { 1.0 }
    });
    let widest = widest.reduce(|| 0.0, f64::max);
    eprintln!("the norm of a stage is at most {widest:.1} times above its responses");
    assert!(widest < 30.0, "{widest} times above");
}

#[test]
fn the_largest_sum_is_twice_the_bound_or_the_limit() {
    assert_eq!(sum_limit(3.0_f64, 2_000.0, 1_000.0).to_bits(), f64::to_bits(6_000.0));
    assert_eq!(sum_limit(3.0_f64, 4_000.0, 1_000.0).to_bits(), f64::to_bits(8_000.0));
    assert_eq!(sum_limit(0.0_f64, 0.0, 1_000.0).to_bits(), f64::to_bits(0.0));
    // what a set can hold
    assert_eq!(sum_limit(f64::INFINITY, 1_000.0, 1_000.0).to_bits(), f64::to_bits(34_359_738_368.0));
}
