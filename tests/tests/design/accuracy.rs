//! Random designs of all types and orders against 80 digits: the error of each number is at most
//!
//! ```text
//! 10 * 2^-53 * (|c| + |dc/dln f0| + |dc/dln Q| + |dc/dln D|)
//! ```
//!
//! that is 10 * 2^-53 * (1 + condition) relative to it, in a form that is also right where a number is near 0. Presets are
//! differences of rounded numbers on purpose, and left out.

use super::exact::Exact;
use super::{CYCLES, inputs};
use axgen_tests::accuracy::fixed::Fixed;
use axgen_tests::environment::by_depth;
use axgen_tests::random::rng::Rng;
use rayon::prelude::*;
use reference::design::band::cycle_time;
use reference::design::inputs::Inputs;
use reference::design::poles::Prototype;
use reference::design::{narrow, stage};
use reference::filter::{self, Type};
use reference::stage::{Coeffs, Mode, Numbers};
use reference::{allpass, bandpass, oscillation};

const SEED: u64 = 20_261_125;
/// The relative step of a difference quotient is 2^-60.
const STEP: usize = 60;
const LIMIT: i32 = 10;

/// A stage with the simulated oscillation, a band-pass and an all-pass, one of these in front.
struct Case {
    structure: Coeffs<f64>,
    prototypes: [Prototype; 2],
    inputs: Inputs<f64>,
    cycle_time_ns: u32,
    bandpass: usize,
}

fn case(index: usize) -> Case {
    let mut rng = Rng::numbered(SEED, index);
    let cycle_time_ns = *rng.pick(&CYCLES);
    let prototype = [Prototype::CritDamping, Prototype::Butterworth, Prototype::Bessel][index % 3];
    let order = index / 3 % 3 + 1;
    let bandpass = index / 9 % 2;
    let mut structure = Coeffs { mode: Mode::Indirect, ..Coeffs::default() };
    structure.filter[bandpass] = filter::Coeffs { kind: Type::Bandpass, order, ..filter::Coeffs::default() };
    structure.filter[1 - bandpass].kind = Type::Allpass;
    let mut inputs = inputs(&mut rng, cycle_time_ns);
    inputs.filter[1] = inputs.filter[0];
    Case { structure, prototypes: [prototype; 2], inputs, cycle_time_ns, bandpass }
}

impl Case {
    fn designed(&self) -> Numbers<f64> {
        let mut numbers = Numbers::default();
        let cycle_time = cycle_time(self.cycle_time_ns);
        stage::design(&mut numbers, &self.structure, &self.prototypes, &self.inputs, cycle_time);
        numbers
    }

    /// In the order of [`Exact::numbers`].
    fn listed(&self, numbers: &Numbers<f64>) -> Vec<f64> {
        let order = self.structure.filter[self.bandpass].order;
        let mut list = Vec::new();
        for bandpass::Coeffs { b2, a1, a2, a, b, c } in &numbers.filter[self.bandpass].bandpass[..order] {
            list.extend([b2, a1, a2, a, b, c]);
        }
        let allpass::Coeffs { a1, a2, a, b, c, .. } = numbers.filter[1 - self.bandpass].allpass;
        list.extend([a1, a2, a, b, c].iter());
        let oscillation::Coeffs { b0, b1, b2, a1, a2, h, r, g, g2, .. } = numbers.oscillation;
        list.extend([b0, b1, b2, a1, a2, h, r, g, g2].iter());
        list
    }

    fn exact(&self) -> Exact {
        let filter = self.inputs.filter[self.bandpass];
        Exact {
            f0: filter.f0.into(),
            q_factor: filter.q_factor.into(),
            damping: self.inputs.damping.into(),
            cycle_time: Fixed::from(f64::from(self.cycle_time_ns)) / Fixed::from(1_000_000_000),
            prototype: self.prototypes[0],
            order: self.structure.filter[self.bandpass].order,
        }
    }

    /// The largest error, as a multiple of 2^-53 (1 + condition).
    fn error(&self) -> f64 {
        let exact = self.exact();
        let of = exact.numbers();
        let near = Fixed::above_one(STEP);
        let varied = [
            Exact { f0: exact.f0.clone() * &near, ..exact.clone() }.numbers(),
            Exact { q_factor: exact.q_factor.clone() * &near, ..exact.clone() }.numbers(),
            Exact { damping: exact.damping.clone() * &near, ..exact }.numbers(),
        ];
        let numbers = self.listed(&self.designed());
        assert_eq!(numbers.len(), of.len());
        let mut worst = 0.0_f64;
        for (i, (number, c)) in numbers.into_iter().zip(of).enumerate() {
            assert!(c.is_precise() || c.to_f64().abs() < 1e-3, "{}", c.to_f64());
            let slopes = varied.iter().map(|varied| (varied[i].clone() - &c).abs().shifted(STEP));
            let scale = slopes.fold(c.clone().abs(), |sum, slope| sum + slope);
            let error = ((Fixed::from(number) - c).abs().shifted(53) / scale).to_f64();
            worst = if error > worst { error } else { worst };
        }
        worst
    }
}

#[test]
fn numbers_have_the_stated_accuracy() {
    let count = by_depth(2_000, 10_000, 100_000);
    let worst = (0..count).into_par_iter().map(|index| (case(index).error(), index));
    let (worst, index) = worst.reduce(|| (0.0, 0), |a, b| if a.0 > b.0 { a } else { b });
    eprintln!("{count} designs: {worst:.2} times 2^-53 (1 + condition), number {index}");
    assert!(worst <= f64::from(LIMIT), "{worst} times 2^-53 (1 + condition): design {index}");
    assert!(worst > 1.0, "the numbers are more accurate than doubles can be: {worst}");
}

#[test]
fn the_oscillation_has_the_centre_of_the_first_band_pass() {
    for (kinds, first) in
        [([Type::Bandpass; 2], 0), ([Type::Bandpass, Type::Allpass], 0), ([Type::Allpass, Type::Bandpass], 1)]
    {
        let filter = kinds.map(|kind| filter::Coeffs { kind, order: 1, ..filter::Coeffs::default() });
        let structure = Coeffs { mode: Mode::SetPoint, filter, ..Coeffs::default() };
        let inputs = inputs(&mut Rng::new(SEED), CYCLES[0]);
        let mut numbers = Numbers::default();
        stage::design(&mut numbers, &structure, &[Prototype::Bessel; 2], &inputs, cycle_time(CYCLES[0]));
        let angle = std::f64::consts::PI * inputs.filter[first].f0 * f64::from(CYCLES[0]) * 1e-9;
        let error = numbers.oscillation.g / libm::tan(angle) - 1.0;
        assert!(error.abs() < 1e-14, "{kinds:?}: {error:e}");
    }
}

/// Each number that a block in single precision uses is the single that is nearest to the double.
#[test]
fn narrowed_numbers_are_the_nearest_singles() {
    for index in 0..by_depth(20_000, 50_000, 1_000_000) {
        let case = case(index);
        let double = case.designed();
        let mut narrowed = double;
        narrow::stage(&mut narrowed, &case.structure);
        let [double, narrowed] = [&double, &narrowed].map(|of| single_numbers(&case, of));
        for (double, narrowed) in double.into_iter().zip(narrowed) {
            assert_eq!(f64::from(double as f32).to_bits(), narrowed.to_bits(), "{double:e}: design {index}");
        }
    }
}

fn single_numbers(case: &Case, numbers: &Numbers<f64>) -> Vec<f64> {
    let order = case.structure.filter[case.bandpass].order;
    let mut list = vec![numbers.gain];
    for bandpass::Coeffs { a, b, c, .. } in &numbers.filter[case.bandpass].bandpass[..order] {
        list.extend([a, b, c]);
    }
    let allpass::Coeffs { a, b, c, .. } = numbers.filter[1 - case.bandpass].allpass;
    let oscillation::Coeffs { h, r, g, g2, .. } = numbers.oscillation;
    list.extend([a, b, c, h, r, g, g2].iter());
    list
}

/// Against digits from tables.
#[test]
fn constants_have_their_digits() {
    for (of, digits) in [
        (Fixed::pi(), "3141592653589793238462643383279502884197169399375105820974944"),
        (&Fixed::from(2).sqrt(), "1414213562373095048801688724209698078569671875376948073176679"),
        (&Fixed::from(2).cbrt(), "1259921049894873164767210607278228350570251464701507980081975"),
        (&Fixed::from(1).tan(), "1557407724654902230506974807458360173087250772381520038383946"),
    ] {
        assert_eq!(of.digits(), digits);
    }
}
