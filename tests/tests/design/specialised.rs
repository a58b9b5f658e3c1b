//! The design of a stage as a program: specialised, through all passes, and interpreted, against the Rust itself, in bits.

use super::CYCLES;
use axgen_tests::environment::by_depth;
use axgen_tests::random::rng::Rng;
use compiler::interp::Machine;
use compiler::program::Program;
use compiler::{leaves, pass, specialise};
use portable::{Block, Literal, Real, portable};
use reference::design::band::cycle_time;
use reference::design::inputs::Inputs;
use reference::design::poles::Prototype;
use reference::design::{narrow, stage as design_stage};
use reference::filter::{Coeffs as Filter, Type};
use reference::stage::{Coeffs as StageCoeffs, FILTERS, Mode, Numbers};
use std::collections::BTreeMap;

/// What is known when the program is made.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// the cycle [ns]
    pub cycle_time_ns: u32,
    /// whether the block that takes the numbers has single precision
    pub is_single: bool,
    /// mode, types and orders
    pub stage: StageCoeffs<R>,
    /// prototype of each filter
    pub prototype: [Prototype; FILTERS],
}

/// What is kept.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// gain of the last design
    pub gain: R,
}

/// The result.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Outputs<R> {
    /// the numbers
    pub numbers: Numbers<R>,
}

/// Before the first design.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    state.gain = R::ZERO;
}

/// One design.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    let mut designed = Outputs::<R>::default();
    let seconds = cycle_time::<R>(coeffs.cycle_time_ns);
    design_stage::design(&mut designed.numbers, &coeffs.stage, &coeffs.prototype, inputs, seconds);
    if coeffs.is_single {
        narrow::stage(&mut designed.numbers, &coeffs.stage);
    }
    state.gain = designed.numbers.gain;
    outputs.numbers = designed.numbers;
}

inside::subject!("design", State<R>, Coeffs<R>, Inputs<R>, Outputs<R>, Coeffs::default());

fn bandpass(order: usize) -> Filter<f64> {
    Filter { kind: Type::Bandpass, order, ..Filter::default() }
}

fn structure(mode: Mode, filter: [Filter<f64>; 2], prototype: Prototype, cycle_time_ns: u32) -> Coeffs<f64> {
    let stage = StageCoeffs { mode, filter, ..StageCoeffs::default() };
    Coeffs { cycle_time_ns, is_single: false, stage, prototype: [prototype; FILTERS] }
}

fn program(coeffs: &Coeffs<f64>) -> Program {
    let program = specialise::block::<f64, Subject>(coeffs, &BTreeMap::new());
    pass::run(program, None).unwrap_or_else(|defect| panic!("{defect}"))
}

/// The program and the Rust on the same random inputs.
fn compare(coeffs: &Coeffs<f64>, count: usize) {
    let program = program(coeffs);
    let (mut machine, mut found) = (Machine::start(&program), Vec::new());
    let mut rng = Rng::new(0x0064_6573_6967_6e00);
    let mut state = <Subject as Block<f64>>::state();
    for _ in 0..count {
        let inputs = super::inputs(&mut rng, coeffs.cycle_time_ns);
        let mut outputs = Outputs::default();
        <Subject as Block<f64>>::step(&mut state, coeffs, &inputs, &mut outputs);
        machine.step(&leaves(&inputs), &mut found);
        let expected: Vec<Literal> = leaves(&outputs).into_iter().map(Literal::at_run_time).collect();
        assert_eq!(found, expected, "{inputs:?}");
    }
}

#[test]
fn programs_have_the_bits_of_the_rust() {
    let allpass = Filter { kind: Type::Allpass, ..Filter::default() };
    let indirect = structure(Mode::Indirect, [bandpass(1), allpass], Prototype::CritDamping, 1_000_000);
    let bessel = structure(Mode::Direct, [bandpass(3), Filter::default()], Prototype::Bessel, 500_000);
    let behind = structure(Mode::SetPoint, [allpass, bandpass(2)], Prototype::Butterworth, 62_500);
    let count = by_depth(10_000, 10_000, 100_000);
    for of in [indirect, bessel, behind] {
        compare(&of, count);
        compare(&Coeffs { is_single: true, ..of }, count / 10);
    }
    for (i, cycle_time_ns) in CYCLES.into_iter().enumerate() {
        let order = i % 3 + 1;
        compare(&structure(Mode::Indirect, [bandpass(order); 2], Prototype::CritDamping, cycle_time_ns), count / 100);
    }
}

/// The square root is in the programs of conjugate pairs only: there is its split by 2^27 + 1.
#[test]
fn only_pairs_have_the_square_root() {
    for prototype in [Prototype::CritDamping, Prototype::Butterworth, Prototype::Bessel] {
        for order in 1..=3 {
            let of = structure(Mode::Direct, [bandpass(order), Filter::default()], prototype, 1_000_000);
            let has_one = program(&of).to_string().contains("134217729");
            assert_eq!(has_one, prototype != Prototype::CritDamping && order > 1, "{prototype:?} {order}");
        }
    }
}
