//! The block `set_design`: from random inputs, hostile ones among them, the set of the generator in every bit, in every engine;
//! what is refused gives no set.
#![expect(
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "a test's small numbers"
)]

mod closed_loop;

use axgen_tests::engines::agree;
use axgen_tests::environment::by_depth;
use axgen_tests::model::subject;
use axgen_tests::random::rng::Rng;
use compiler::leaves;
use compiler::program::{Program, Type};
use generator::axis::{Filter, Mode};
use generator::blocks::{Block, Designed, named};
use golden::case::named_block;
use golden::samples::{Samples, Shape};
use portable::{Literal, Portable, Real, RealKind};
use rayon::prelude::*;
use reference::design::inputs::Wrong;
use reference::set_design::error_of;
use reference::sets::{Coeffs, params, refusal};

/// The structures: everything that a stage may have.
const STRUCTURES: [&str; 5] = [
    "{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }",
    "{ mode = 'INDIRECT', osc_damping = 0.8, filter = [{ order = 1, fg_f0 = 11, q_factor = 2 }, { type = 'ALLPASS', fg_f0 = 90, q_factor = 2 }] }",
    "{ mode = 'SET_POINT', osc_damping = 0.3, filter = [{ type = 'ALLPASS', fg_f0 = 60, q_factor = 3 }, { type = 'BANDPASS', order = 2, prototype = 'BUTTERWORTH', fg_f0 = 31, q_factor = 4 }] }",
    "{ mode = 'DIRECT', filter = [{ order = 3, prototype = 'BESSEL', fg_f0 = 40, q_factor = 5 }, { type = 'BANDPASS', order = 1, prototype = 'CRIT_DAMPING', fg_f0 = 41, q_factor = 6 }] }",
    "{ mode = 'DIRECT', filter = [{ order = 3, prototype = 'CRIT_DAMPING', fg_f0 = 30, q_factor = 7 }] }, { mode = 'INDIRECT', osc_damping = 0.5, \
     filter = [{ order = 3, prototype = 'BUTTERWORTH', fg_f0 = 15, q_factor = 8 }, { type = 'ALLPASS', fg_f0 = 25, q_factor = 9 }] }, \
     { mode = 'SET_POINT', osc_damping = 0.9, filter = [{ type = 'NO_FILTER' }, { type = 'BANDPASS', order = 2, prototype = 'BESSEL', fg_f0 = 70, q_factor = 1 }] }",
];
const LOWEST: f64 = 8.0;
const LARGEST_FACT: u32 = 400;
/// The smallest limit other than 0.
const SMALLEST: f64 = 1.0 / 1_048_576.0;
const KINDS: [RealKind; 2] = [RealKind::F64, RealKind::F32];

/// An axis whose controller designs sets.
fn base(structure: usize, real: RealKind) -> Designed {
    let (cycle, watch) = [("1ms", "false"), ("250us", "true")][structure % 2];
    let real = if real == RealKind::F64 { "f64" } else { "f32" };
    subject::read(&format!(
        "cycle_time = '{cycle}'\n[axis.X]\nreal = '{real}'\ntunable = 'parameters'\nlowest_f0 = {LOWEST}\nwatch = {watch}\n\
         getriebe = [{{ dynamik.vb_max = 530000 }}]\n[axis.X.lr_param.improved_position_control]\nenable = 'DRYRUN'\n\
         v_add_max_fact = {LARGEST_FACT}\nstage = [{}]\n",
        STRUCTURES[structure]
    ))
}

/// Inputs by their paths, and what they must give: `error_id`, `wrong_stage`, `wrong_filter`.
#[derive(Default)]
struct Typed {
    inputs: Vec<(String, f64)>,
    refused: [u32; 3],
}

/// In 0..1.
fn unit(rng: &mut Rng) -> f64 {
    (rng.word() >> 11) as f64 / 9_007_199_254_740_992.0
}

/// One of both ends of a range, or any value.
fn one_of(low: f64, high: f64, any: f64, rng: &mut Rng) -> f64 {
    *[low, high].get(rng.below(10)).unwrap_or(&any)
}

/// Other values within their ranges in an axis, and as they are typed; one in three is spoilt.
fn typed(of: &mut Designed, rng: &mut Rng) -> Typed {
    let mut axis = of.axis.clone();
    let highest = (0.45e9 / f64::from(axis.cycle_time_ns)).min(500.0);
    // With the limit 0 the generator leaves the watch out, which is another structure.
    let least = usize::from(axis.ipc.watch);
    axis.ipc.v_add_max_fact = (least + rng.below(LARGEST_FACT as usize + 1 - least)) as u32;
    let mut inputs = vec![("limit".to_owned(), axis.ipc.limit())];
    for (i, stage) in axis.ipc.stage.iter_mut().enumerate() {
        let Some(stage) = stage else { continue };
        stage.weight_fact_num = 1 + rng.below(7000) as u32;
        stage.weight_fact_denom = 1000;
        inputs.push((format!("stage[{i}].weight"), stage.weight()));
        let ratio = one_of(1e-9, 1.0 - 1e-9, unit(rng).clamp(1e-3, 0.999), rng);
        if let Mode::Indirect { osc_damping } | Mode::SetPoint { osc_damping } = &mut stage.mode {
            *osc_damping = ratio;
            inputs.push((format!("stage[{i}].damping"), ratio));
        }
        for (k, filter) in stage.filter.iter_mut().enumerate() {
            let (Filter::Bandpass { f0, q_factor, .. } | Filter::Allpass { f0, q_factor }) = filter else { continue };
            *f0 = one_of(LOWEST, highest, LOWEST * libm::pow(highest / LOWEST, unit(rng)), rng);
            *q_factor = one_of(1.0, 10.0, 1.0 + 9.0 * unit(rng), rng);
            inputs.push((format!("stage[{i}].filter[{k}].f0"), *f0));
            inputs.push((format!("stage[{i}].filter[{k}].q_factor"), *q_factor));
        }
    }
    *of = Designed::from(axis);
    spoilt(inputs, highest, rng)
}

/// Spoils one input in three.
fn spoilt(mut inputs: Vec<(String, f64)>, highest: f64, rng: &mut Rng) -> Typed {
    if !rng.chance(33) {
        return Typed { inputs, ..Typed::default() };
    }
    let at = rng.below(inputs.len());
    let (outside, wrong) = match inputs[at].0.rsplit('.').next().unwrap() {
        "f0" => {
            let low = [LOWEST.next_down(), LOWEST / 2.0, 5e-324];
            let wrong = [0.0, -0.0, -LOWEST, highest.next_up(), 1e300];
            if rng.chance(40) { (*rng.pick(&low), Wrong::LowFrequency) } else { (*rng.pick(&wrong), Wrong::Frequency) }
        }
        "q_factor" => (*rng.pick(&[1f64.next_down(), 10f64.next_up(), 0.0, -2.0, 1e300]), Wrong::QualityFactor),
        "damping" => (*rng.pick(&[0.0, -0.0, 5e-324, 1.0, 1.5, -0.5]), Wrong::Damping),
        "weight" => (*rng.pick(&[0.0, -0.0, 5e-324, 7f64.next_up(), -1.0, 1e300]), Wrong::Weight),
        _ => (*rng.pick(&[5e-324, SMALLEST.next_down(), -5e-324, -1.0, 212_000f64.next_up(), 1e300]), Wrong::Limit),
    };
    let is_number = rng.chance(70);
    inputs[at].1 = if is_number { outside } else { *rng.pick(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY]) };
    let wrong = if is_number || wrong != Wrong::LowFrequency { wrong } else { Wrong::Frequency };
    // It comes before the damping ratio of its stage.
    let next = inputs.get_mut(at + 1).filter(|(path, _)| wrong == Wrong::Weight && path.ends_with("damping"));
    next.into_iter().for_each(|(_, damping)| *damping = f64::NAN);
    let mut places = inputs[at].0.split(['[', ']']).filter_map(|part| part.parse().ok());
    let [stage, filter] = [(); 2].map(|()| places.next().unwrap_or(0));
    Typed { refused: [error_of(wrong), stage, filter], inputs }
}

/// The scalars of the set that the generator makes of an axis, in double precision, and whether its block accepts them.
fn set<R: Real>(of: &Designed) -> (Vec<Literal>, u32)
where
    reference::tunable_ipc::TunableIpc: portable::Block<R, Coeffs = Coeffs<R>>,
{
    let mut coefficients = named("ipc").unwrap().coefficients(of).into_iter();
    let coeffs = Coeffs::<R>::build(&mut || coefficients.next().unwrap());
    let set = params(&coeffs);
    let wide = |leaf| if let Literal::F32(x) = leaf { Literal::F64(x.into()) } else { leaf };
    (leaves(&set).into_iter().map(wide).collect(), refusal(&coeffs, &set))
}

fn place(program: &Program, path: &str) -> usize {
    program.outputs.iter().position(|output| output.path == path).unwrap()
}

/// The inputs of a design: the button, and what was typed.
fn values(program: &Program, typed: &Typed, execute: bool) -> Vec<Literal> {
    let value = |input: &compiler::program::Variable| match input.ty {
        Type::Real => {
            typed.inputs.iter().find(|(path, _)| *path == input.path).map_or(input.start, |(_, x)| Literal::F64(*x))
        }
        _ => Literal::Bool(execute),
    };
    program.inputs.iter().map(value).collect()
}

/// One structure: random inputs in the reference against the generator.
fn compare(structure: usize, real: RealKind, count: usize) {
    let base = base(structure, real);
    let block = named_block(&base, "set_design").unwrap();
    let (program, calls) = (&block.program, generator::blocks::calls_of_design(&base));
    let mut run = named("set_design").unwrap().start(&base);
    let own: Vec<usize> =
        block.for_axis.outputs.iter().copied().filter(|at| program.in_made(&program.outputs[*at]).is_some()).collect();
    let first = place(program, "params.structure");
    let (mut rng, mut outputs, mut accepted) = (Rng::new(0x5e7 + structure as u64), Vec::new(), 0);
    for n in 0..=count {
        let mut other = base.clone();
        let mut typed = typed(&mut other, &mut rng);
        if n == count {
            typed = Typed { inputs: vec![("limit".to_owned(), SMALLEST)], ..Typed::default() };
        }
        // A design that the next one interrupts leaves nothing.
        for (typed, calls) in [(&Typed::default(), rng.below(8)), (&typed, calls)] {
            run.step(&values(program, typed, false), &mut outputs);
            (0..calls).for_each(|_| run.step(&values(program, typed, true), &mut outputs));
        }
        let is = |path| outputs[place(program, path)];
        let context = || format!("structure {structure} {real:?}, {n}: {:?}", typed.inputs);
        assert_eq!(is("active"), Literal::Bool(false), "{}", context());
        let refused = ["error_id", "wrong_stage", "wrong_filter"].map(is);
        assert_eq!(refused, typed.refused.map(Literal::U32), "{}", context());
        let is_refused = typed.refused[0] != 0;
        assert_eq!(is("designed"), Literal::Bool(!is_refused), "{}", context());
        assert_eq!(is("params.set_id") == Literal::U32(0), is_refused, "{}", context());
        // The last limit is smaller than any that the generator can make.
        if is_refused || n == count {
            continue;
        }
        let (expected, refused) = if real == RealKind::F64 { set::<f64>(&other) } else { set::<f32>(&other) };
        for at in &own {
            assert_eq!(outputs[*at], expected[*at - first], "{}: {}", program.outputs[*at].path, context());
        }
        // In single precision the oscillation of a damping ratio of 1e-9 does not decay: the block refuses both sets.
        let decays = typed.inputs.iter().all(|(path, x)| !path.ends_with("damping") || *x >= 1e-3);
        assert!(refused == 0 || !decays, "{}: {refused}", context());
        accepted += 1;
    }
    assert!(accepted > count / 3 && accepted < count, "{accepted} of {count}");
}

#[test]
fn the_set_is_that_of_the_generator() {
    let all: Vec<_> = (0..STRUCTURES.len()).flat_map(|structure| KINDS.map(|real| (structure, real))).collect();
    all.into_par_iter().for_each(|(structure, real)| compare(structure, real, by_depth(50, 500, 10_000)));
}

/// A weight that is typed while a set is designed: the set is that of the old or of the new weight.
#[test]
fn a_set_is_of_one_weight() {
    for structure in 0..STRUCTURES.len() {
        let base = base(structure, RealKind::F64);
        let (block, calls) = (named_block(&base, "set_design").unwrap(), generator::blocks::calls_of_design(&base));
        let typed = |weight| Typed { inputs: vec![("stage[0].weight".to_owned(), weight)], ..Typed::default() };
        let given = [1.0, 3.0].map(typed);
        let made = |from: usize| {
            let (mut run, mut outputs) = (named("set_design").unwrap().start(&base), Vec::new());
            let inputs = |n| values(&block.program, &given[usize::from(n > from)], n > 0);
            (0..=calls).for_each(|n| run.step(&inputs(n), &mut outputs));
            outputs
        };
        let sets = [made(calls), made(0)];
        assert!(sets[0] != sets[1] && (1..calls).all(|from| sets.contains(&made(from))), "structure {structure}");
    }
}

/// Runs of an operator: the button at any time, inputs inside and outside their ranges, some changed while a set is designed.
fn samples(base: &Designed, block: &Block, length: usize) -> Samples {
    let (program, mut rng) = (&block.program, Rng::new(23));
    let mut samples = Samples::with_capacity(Shape::of(&program.inputs, program.real), length);
    let calls = generator::blocks::calls_of_design(base);
    let (mut given, mut left, mut pressed) = (Typed::default(), 0, false);
    for _ in 0..length {
        if left == 0 {
            let mut other = base.clone();
            given = typed(&mut other, &mut rng);
            pressed = !pressed && rng.chance(90);
            left = if pressed && rng.chance(80) { calls + 2 } else { 1 + rng.below(20) };
        }
        left -= 1;
        samples.push(&values(program, &given, pressed));
    }
    samples
}

#[test]
fn every_engine_makes_the_same_sets() {
    for structure in 0..STRUCTURES.len() {
        for real in KINDS {
            let base = base(structure, real);
            let block = named_block(&base, "set_design").unwrap();
            let inputs = samples(&base, &block, by_depth(1_000, 5_000, 1_000_000));
            let expected = golden::engine::run(golden::engine::Engine::Reference, &base, &block, &inputs).unwrap();
            agree(&format!("structure {structure} {real:?}"), &base, &block, &inputs, &expected);
        }
    }
}
