//! The bounds against brute force: impulse responses that are added up to the end, and the inputs that are the worst.

use super::{block, certified, one_band_pass, rack_and_pinion};
use crate::inside::sets;
use compiler::interp::Machine;
use compiler::program::{Program, Type};
use generator::axis::{Axis, Prototype};
use generator::blocks::Designed;
use generator::blocks::ipc::certificate::chain::measure;
use generator::blocks::ipc::certificate::norm::{BUDGET, Bound, run as add_up};
use portable::{Extreme, Literal, RealKind};

/// A block whose limit never acts, and its bound for inputs within +-1.
fn unlimited(axis: &Axis) -> (Program, Bound) {
    let block = block(axis);
    let bound = certified(axis).bound;
    let mut program = block.program;
    for constant in &mut program.constants {
        let value = match constant.path.as_str() {
            "limit" => 1e30,
            "lower_limit" => -1e30,
            "rest" => 0.0,
            _ => continue,
        };
        constant.value = real(program.real, value);
    }
    (program, bound)
}

#[expect(clippy::cast_possible_truncation, reason = "rounded as a sample is")]
fn real(kind: RealKind, value: f64) -> Literal {
    match kind {
        RealKind::F64 => Literal::F64(value),
        RealKind::F32 => Literal::F32(value as f32),
    }
}

fn number(value: Literal) -> f64 {
    match value {
        Literal::F64(value) => value,
        Literal::F32(value) => f64::from(value),
        _ => 0.0,
    }
}

/// Runs the block, preset at 0, on the same samples at all real inputs; gives all reals of the state and v_add_calculated.
fn run(program: &Program, samples: impl Iterator<Item = f64>) -> Vec<Vec<f64>> {
    let mut machine = Machine::start(program);
    let mut outputs = Vec::new();
    let mut inputs: Vec<Literal> = program.inputs.iter().map(|input| input.start).collect();
    let is_real: Vec<bool> = program.inputs.iter().map(|input| input.ty == Type::Real).collect();
    let mode = program.inputs.iter().position(|input| input.path == "mode").expect("a mode");
    inputs[mode] = Literal::I32(1);
    machine.step(&inputs, &mut outputs);
    let v_add = program.outputs.iter().position(|output| output.path == "v_add_calculated").expect("the output");
    let states: Vec<usize> = (0..program.state.len()).filter(|i| program.state[*i].ty == Type::Real).collect();
    let step = |x| {
        for (input, is_real) in inputs.iter_mut().zip(&is_real) {
            if *is_real {
                *input = real(program.real, x);
            }
        }
        machine.step(&inputs, &mut outputs);
        let mut values: Vec<f64> = states.iter().map(|state| number(machine.state()[*state])).collect();
        values.push(number(outputs[v_add]));
        values
    };
    samples.map(step).collect()
}

fn impulse(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(|n| if n == 0 { 1.0 } else { 0.0 })
}

/// All stages of these look at one input, so that one impulse is enough.
#[test]
fn where_decay_is_short_the_bound_is_the_sum() {
    let short = one_band_pass(RealKind::F64, 1_000_000, Prototype::Butterworth, 3, 120.0, 3.0);
    let double = one_band_pass(RealKind::F64, 1_000_000, Prototype::CritDamping, 3, 40.0, 10.0);
    for axis in [rack_and_pinion(RealKind::F64), short, double] {
        let (program, bound) = unlimited(&axis);
        let responses = run(&program, impulse(20_000));
        let sum = |place: usize| responses.iter().map(|values| values[place].abs()).sum::<f64>();
        let last = responses[0].len() - 1;
        let largest = (0..last).map(sum).fold(0.0, f64::larger);
        for (bound, sum) in [(bound.state, largest), (bound.v_sum, sum(last))] {
            assert!(bound >= sum && bound <= sum * (1.0 + 2e-4), "{bound} for {sum}");
        }
    }
}

/// How much of the bound of a block with one stage was added up sample by sample.
fn summed(axis: &Axis) -> f64 {
    let (designed, program) = (Designed::from(axis.clone()), block(axis).program);
    let stages: Vec<_> = designed.stage.iter().flatten().collect();
    let chain = measure(&program, &stages, axis.ipc.limit()).remove(0);
    add_up(&chain, BUDGET / chain.section.len(), axis.real).response.iter().map(|h| h.abs()).sum()
}

/// Of samples of +-1 these make v_add the largest after `count` samples.
fn worst(response: &[f64]) -> impl Iterator<Item = f64> {
    response.iter().rev().map(|h| if *h < 0.0 { -1.0 } else { 1.0 })
}

/// Filters from f0 Ts 2e-5 to 0.4, both real types; the worst samples for v_add and random signs.
#[test]
fn the_worst_samples_reach_it_and_none_exceeds_it() {
    let mut random = sets::Random(3);
    for _ in 0..100 {
        let product = 2e-5 * libm::pow(2e4, random.unit());
        let prototype = [Prototype::CritDamping, Prototype::Butterworth, Prototype::Bessel][random.below(3)];
        let real = any_real(&mut random);
        let (order, q_factor) = (1 + random.below(3), 1.0 + 9.0 * random.unit());
        let axis = one_band_pass(real, 1_000_000, prototype, order, product * 1e3, q_factor);
        let (program, bound) = unlimited(&axis);
        // As many samples as are added up at the most, or all that do not vanish.
        let count = if product < 1e-2 { 9_000 } else { 4_000 };
        let last = program.state.iter().filter(|state| state.ty == Type::Real).count();
        let response: Vec<f64> = run(&program, impulse(count)).iter().map(|values| values[last]).collect();
        let signs: Vec<f64> = (0..count).map(|_| if random.below(2) == 0 { -1.0 } else { 1.0 }).collect();
        let mut reached = 0.0_f64;
        for values in run(&program, worst(&response)).into_iter().chain(run(&program, signs.into_iter())) {
            stays_within(&values, last, &bound, &axis);
            reached = reached.larger(values[last].abs());
        }
        let summed = summed(&axis);
        assert!(reached >= 0.9 * summed, "{reached} of {summed}: {axis:?}");
    }
}

/// Whole blocks in each real type, each input with signs of its own making.
#[test]
fn no_samples_exceed_it_in_whole_blocks() {
    let mut random = sets::Random(5);
    for axis in [RealKind::F64, RealKind::F32].into_iter().flat_map(|real| sets::axes(60, real)) {
        let (program, bound) = unlimited(&axis);
        let last = program.state.iter().filter(|state| state.ty == Type::Real).count();
        let f0 = axis.ipc.stage.iter().flatten().next().expect("a stage").f0() * axis.cycle_time();
        // A square wave at the centre, with faults: near the worst.
        let wave = |n: u32| libm::sin(core::f64::consts::TAU * f0 * f64::from(n));
        let samples = (0..2000_u32).map(|n| if wave(n) < 0.0 { -1.0 } else { 1.0 });
        let samples = samples.map(|x| if random.below(50) == 0 { -x } else { x });
        for values in run(&program, samples) {
            stays_within(&values, last, &bound, &axis);
        }
    }
}

fn any_real(random: &mut sets::Random) -> RealKind {
    if random.below(2) == 0 { RealKind::F32 } else { RealKind::F64 }
}

/// The states, then `v_sum`.
fn stays_within(values: &[f64], last: usize, bound: &Bound, axis: &Axis) {
    let state = values[..last].iter().fold(0.0_f64, |largest, value| largest.larger(value.abs()));
    assert!(state <= bound.state, "state {state} > {}: {axis:?}", bound.state);
    assert!(values[last].abs() <= bound.v_sum, "v_sum {} > {}: {axis:?}", values[last], bound.v_sum);
}

#[test]
fn the_lowest_frequency_has_a_bound_too() {
    let axis = one_band_pass(RealKind::F64, 62_500, Prototype::Butterworth, 3, 0.016, 10.0);
    let bound = certified(&axis).bound;
    // Sections of quality factor 10, 20 and 20, each at most 4/pi times its quality's build-up: far below this.
    assert!(bound.v_sum.is_finite() && bound.v_sum < 100.0 && bound.state < 100.0, "{bound:?}");
    assert!(bound.v_sum > 1.0);
}
