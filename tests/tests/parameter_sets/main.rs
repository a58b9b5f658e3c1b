//! The blocks `ipc` and `axis` whose numbers come from parameter sets: sets that are offered at any moment, whole, torn and corrupted,
//! through every engine; what is never taken over; how far the output may step.
#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::float_cmp,
    clippy::unwrap_used,
    reason = "small random numbers, bits and a test that stops at the first mistake"
)]

mod axes;
mod constants;
mod corrupted;
mod written_meanwhile;

use axes::{FACT, STRUCTURES, block, other, set, sets};
use axgen_tests::engines::agree;
use axgen_tests::environment::by_depth;
use axgen_tests::random::rng::Rng;
use compiler::leaves;
use compiler::program::Type;
use corrupted::{Set, are_same, corrupted, real};
use generator::blocks::{Block, Designed};
use golden::engine::{self, Engine};
use golden::samples::{Samples, Shape};
use golden::subject::number;
use portable::{Literal, Portable, Real, RealKind};
use rayon::prelude::*;
use reference::ipc::numbers::Params;
use reference::sets::{self, Coeffs};
use reference::tunable_ipc::{self, TunableIpc};

/// Cycles of a run.
const RUN: usize = 12_000;
/// Sets that are offered in turn.
const SETS: usize = 6;
const KINDS: [RealKind; 2] = [RealKind::F64, RealKind::F32];

/// A block, sets of its structure, one of another structure, and one whose limit is above the block's.
struct Bench {
    designed: Designed,
    block: Block,
    sets: Vec<Set>,
    foreign: Set,
    beyond: Set,
}

/// The coefficients of the block of an axis.
fn coeffs<R: Real>(of: &Designed) -> Coeffs<R>
where
    TunableIpc: portable::Block<R, Coeffs = Coeffs<R>>,
{
    let kind = generator::blocks::named("ipc").unwrap();
    let mut coefficients = kind.coefficients(of).into_iter();
    Coeffs::build(&mut || coefficients.next().unwrap())
}

fn bench(structure: usize, kind: RealKind) -> Bench {
    let mut rng = Rng::new(7 + structure as u64);
    let designed = other(structure, kind, &mut rng, FACT);
    let block = block(structure, &designed);
    let mut sets = sets(structure, kind, &mut rng, SETS);
    sets.push(set(&block));
    let foreign = set(&axes::block(structure, &other((structure + 1) % STRUCTURES, kind, &mut rng, FACT)));
    let beyond = set(&axes::block(structure, &other(structure, kind, &mut rng, FACT + 1)));
    Bench { designed, block, sets, foreign, beyond }
}

/// Vibrations, modes and disturbances, and sets that are offered, torn, corrupted, taken back.
fn samples(bench: &Bench, length: usize) -> Samples {
    let program = &bench.block.program;
    let mut rng = Rng::new(5);
    let mut uniform = Rng::new(6);
    let mut uniform = move || (uniform.word() >> 11) as f64 / 2f64.powi(53);
    let shape = Shape::of(&program.inputs, program.real);
    let mut samples = Samples::with_capacity(shape, length);
    let mut values: Vec<Literal> = program.inputs.iter().map(|input| input.start).collect();
    // Before the first whole set some are refused.
    let mut offered = corrupted(&bench.sets[0], &bench.sets, &bench.foreign, &mut rng);
    let mut mode = 1;
    for cycle in 0..length {
        let whole = &bench.sets[rng.below(bench.sets.len())];
        match uniform() {
            of if of < 0.0015 => offered = whole.clone(),
            of if of < 0.0022 => offered = corrupted(whole, &bench.sets, &bench.foreign, &mut rng),
            of if of < 0.0025 => offered = bench.foreign.clone(),
            of if of < 0.0028 => offered = bench.beyond.clone(),
            _ => {}
        }
        if uniform() < 0.002 {
            mode = *rng.pick(&[0, 1, 1, 1, 2, 3]);
        }
        for (at, value) in &offered {
            if std::mem::discriminant(&values[*at]) == std::mem::discriminant(value) {
                values[*at] = *value;
            }
        }
        let vibration = 4e4 * (cycle as f64 * 0.31).sin() + 2e4 * uniform();
        for (input, value) in program.inputs.iter().zip(&mut values) {
            *value = match (input.path.as_str(), input.ty) {
                _ if program.in_set(input).is_some() => *value,
                ("mode", _) => Literal::I32(mode),
                ("reset", _) => Literal::Bool(uniform() < 0.001),
                ("position_controlled", _) => Literal::Bool(uniform() > 0.001),
                (_, Type::Real) if uniform() < 0.0005 => real(f64::NAN, program.real),
                (_, Type::Real) => real(vibration * (1.0 + 0.1 * uniform()), program.real),
                _ => input.start,
            };
        }
        samples.push(&values);
    }
    samples
}

#[test]
fn sets_at_any_moment_give_the_same_bits_in_every_engine() {
    let length = RUN * by_depth(1, 2, 15);
    let cases: Vec<(usize, RealKind)> =
        (0..STRUCTURES).flat_map(|structure| KINDS.map(|kind| (structure, kind))).collect();
    let cycles: usize = cases
        .par_iter()
        .map(|(structure, kind)| {
            let bench = bench(*structure, *kind);
            let inputs = samples(&bench, length);
            let expected = engine::run(Engine::Reference, &bench.designed, &bench.block, &inputs).unwrap();
            takes_over_at_rest(&inputs, &expected, &bench);
            agree(&format!("structure {structure} in {kind:?}"), &bench.designed, &bench.block, &inputs, &expected);
            length
        })
        .sum();
    eprintln!("{cycles} cycles with sets at any moment in every engine: 0 differing bits");
    assert_eq!(cycles, 2 * STRUCTURES * length);
}

/// A value of an output, reals in double precision.
fn value(values: &[Literal], shape: &Shape, name: &str) -> f64 {
    number(values[shape.place(name).unwrap_or_else(|| panic!("no `{name}`"))])
}

/// Where the set in use changes nothing is added, in that cycle and in the one before; only whole sets are ever in use; all
/// of them are at some time, and refusals of every kind; the output steps by no more than its own motion and a step of the
/// fade.
fn takes_over_at_rest(inputs: &Samples, outputs: &Samples, bench: &Bench) {
    let ids: Vec<Literal> = bench.sets.iter().map(|set| set[1].1).collect();
    let fade_cycles = f64::from(bench.designed.ipc.fade_cycles);
    let [mut now, mut before, mut given] = [const { Vec::new() }; 3];
    let (mut used, mut told, mut changes) = (Vec::new(), Vec::new(), 0);
    let of = |values: &[Literal], name: &str| value(values, &outputs.shape, name);
    for sample in 0..outputs.len() {
        outputs.read(sample, &mut now);
        inputs.read(sample, &mut given);
        let id = of(&now, "active_set");
        if sample > 0 {
            let steps = (of(&now, "v_add") - of(&before, "v_add")).abs();
            if id != of(&before, "active_set") {
                changes += 1;
                assert!(steps == 0.0 && of(&now, "v_add") == 0.0, "sample {sample}: a set is taken over in motion");
            }
            let is_cut = of(&now, "fault") == 1.0 || value(&given, &inputs.shape, "reset") == 1.0;
            let is_cut = is_cut || value(&given, &inputs.shape, "position_controlled") == 0.0;
            let is_off = value(&given, &inputs.shape, "mode") == 0.0;
            let was_off = sample > 0 && of(&before, "v_add_calculated") == 0.0;
            if !is_cut && !is_off && !was_off {
                let own = (of(&now, "v_add_calculated") - of(&before, "v_add_calculated")).abs();
                let bound = own + bench.designed.ipc.limit / fade_cycles * (1.0 + 1e-5);
                assert!(steps <= bound, "sample {sample}: v_add steps by {steps}, bound {bound}");
            }
        }
        if !used.contains(&id) {
            used.push(id);
        }
        let error = of(&now, "error_id");
        if !told.contains(&error) {
            told.push(error);
        }
        std::mem::swap(&mut now, &mut before);
    }
    let is_whole = |id: &f64| *id == 0.0 || ids.contains(&Literal::U32(*id as u32));
    assert!(used.iter().all(is_whole), "only whole sets are taken over: {used:?}");
    assert!(used.len() >= SETS && changes > 12, "{} sets in use, {changes} changes", used.len());
    assert!([6.0, 7.0, 8.0].iter().all(|id| told.contains(id)), "every refusal is told: {told:?}");
}

/// Of so many corrupted sets of a block, how many a block takes over although they are other numbers than those of a whole set.
fn taken_over<R: Real>(structure: usize, count: usize) -> (usize, usize)
where
    TunableIpc: portable::Block<R, Coeffs = Coeffs<R>>,
{
    let bench = bench(structure, R::KIND);
    let coeffs = coeffs::<R>(&bench.designed);
    let usual = leaves(&sets::params(&coeffs));
    let first = bench.sets[0][0].0;
    let mut rng = Rng::new(11);
    let (mut taken, mut changed) = (0, 0);
    for _ in 0..count {
        let whole = &bench.sets[rng.below(bench.sets.len())];
        let offered = corrupted(whole, &bench.sets, &bench.foreign, &mut rng);
        let mut leaves = usual.clone();
        offered.iter().zip(whole).for_each(|((_, value), (at, _))| leaves[at - first] = *value);
        let mut leaves = leaves.into_iter();
        let params = Params::<R>::build(&mut || leaves.next().unwrap());
        if bench.sets.iter().all(|set| !are_same(&offered, set)) {
            changed += 1;
            taken += usize::from(sets::refusal(&coeffs, &params) == 0);
        }
    }
    (taken, changed)
}

#[test]
fn no_corrupted_set_is_taken_over() {
    let count = by_depth(1_000, 2_500, 40_000);
    let counts: Vec<(usize, usize)> = (0..STRUCTURES)
        .into_par_iter()
        .flat_map_iter(|structure| [taken_over::<f64>(structure, count), taken_over::<f32>(structure, count)])
        .collect();
    let taken: usize = counts.iter().map(|(taken, _)| taken).sum();
    let changed: usize = counts.iter().map(|(_, changed)| changed).sum();
    eprintln!("{taken} of {changed} corrupted sets were taken over");
    assert_eq!(taken, 0);
    assert!(changed > count * 5, "{changed} of {} were changed", count * 6);
}

/// An axis of the same structure and numbers, by another name.
#[test]
fn a_set_of_another_axis_is_refused() {
    let bench = bench(1, RealKind::F64);
    let axis = generator::axis::Axis { name: "Y".to_owned(), ..bench.designed.axis.clone() };
    let [own, other] = [&bench.designed, &Designed::from(axis)].map(coeffs::<f64>);
    assert_ne!(own.structure, other.structure);
    assert_eq!(sets::refusal(&own, &sets::params(&own)), 0);
    assert_eq!(sets::refusal(&own, &sets::params(&other)), 6);
}

/// Neither an overwritten state nor what is offered then arms a tripped watch again: only the caller's mode does, or a reset.
#[test]
fn behind_a_fault_of_the_state_a_tripped_watch_stays_tripped() {
    let is_watched = |coeffs: &Coeffs<f64>| coeffs.ipc.watch.active;
    let mut all = (0..STRUCTURES).map(|structure| coeffs::<f64>(&bench(structure, RealKind::F64).designed));
    let coeffs = all.find(is_watched).expect("a structure with a watch");
    for is_refused in [false, true] {
        let mut inputs = <TunableIpc as portable::Block<f64>>::inputs(&coeffs);
        let mut state = tunable_ipc::State::<f64>::default();
        let mut outputs = tunable_ipc::Outputs::<f64>::default();
        tunable_ipc::init(&mut state);
        let mut told = false;
        for cycle in 0..3_000 {
            let v = 1000.0 * (f64::from(cycle) * 0.3).sin();
            (inputs.v_command, inputs.v_motor, inputs.v_direct, inputs.mode) = (v, v, v, 1);
            match cycle {
                800 => state.ipc.watch.tripped = true,
                810 if is_refused => inputs.params.structure += 1,
                // In the fade out, and after it.
                820 | 1500 => state.ipc.fade = u32::MAX,
                2000 => inputs.params = sets::params(&coeffs),
                _ => {}
            }
            tunable_ipc::step(&mut state, &coeffs, &inputs, &mut outputs);
            told |= outputs.error_id == 3;
            assert!(cycle < 800 || outputs.tripped, "cycle {cycle}");
            assert!(cycle < 2500 || outputs.v_add == 0.0 && outputs.active_set != 0, "cycle {cycle}");
        }
        assert!(told);
        inputs.mode = 0;
        tunable_ipc::step(&mut state, &coeffs, &inputs, &mut outputs);
        assert!(!outputs.tripped);
    }
}

/// After a fault of the state no number in use is trusted: with a set that is refused nothing is added until a sound one is
/// offered.
#[test]
fn behind_a_fault_of_the_state_a_refused_set_leaves_none_in_use() {
    let coeffs = coeffs::<f64>(&bench(0, RealKind::F64).designed);
    let mut inputs = <TunableIpc as portable::Block<f64>>::inputs(&coeffs);
    let whole = inputs.params;
    let mut state = tunable_ipc::State::<f64>::default();
    let mut outputs = tunable_ipc::Outputs::<f64>::default();
    tunable_ipc::init(&mut state);
    let mut ids = Vec::new();
    for cycle in 0..2_000 {
        inputs.v_motor = 1000.0 * (f64::from(cycle) * 0.3).sin();
        match cycle {
            500 => inputs.params.structure += 1,
            600 => inputs.params.set_id += 1,
            1000 => state.own.now.limit = 1e12,
            1001 => state.own.now.stage[0].gain = f64::NAN,
            1500 => inputs.params = whole,
            _ => {}
        }
        tunable_ipc::step(&mut state, &coeffs, &inputs, &mut outputs);
        let told = (outputs.fault, outputs.error_id, outputs.active_set != 0);
        if ids.last() != Some(&told) {
            ids.push(told);
        }
        assert!(outputs.v_add.abs() <= coeffs.ipc.limit && (told.2 || outputs.v_add == 0.0), "cycle {cycle}");
    }
    let checked = (false, 0, false);
    let expected =
        [checked, (false, 0, true), (false, 6, true), (true, 3, false), (true, 6, false), checked, (false, 0, true)];
    assert_eq!(ids, expected);
    assert!(outputs.v_add != 0.0);
}

/// A whole set, and the same once more with the number of a part changed so that only one rule is broken.
#[test]
fn every_refusal_has_its_id() {
    let bench = bench(0, RealKind::F64);
    let coeffs = coeffs::<f64>(&bench.designed);
    let whole = sets::params(&coeffs);
    let after = |change: &dyn Fn(&mut Params<f64>)| {
        let mut params = whole;
        change(&mut params);
        // The number fits, so that nothing but the rule refuses it.
        sets::seal(&coeffs, &mut params);
        sets::refusal(&coeffs, &params)
    };
    assert_eq!(after(&|_| ()), 0);
    assert_eq!(after(&|params| params.structure += 1), 6);
    let halve =
        |params: &mut Params<f64>| (params.limit, params.lower_limit) = (params.limit / 2.0, -params.limit / 2.0);
    assert_eq!(after(&halve), 0);
    let raise =
        |params: &mut Params<f64>| (params.limit, params.lower_limit) = (params.limit * 1.1, -params.limit * 1.1);
    assert_eq!(after(&|params| params.limit = coeffs.ipc.limit * 0.5), 7, "lower_limit is not -limit");
    assert_eq!(after(&raise), 7, "the limit is above the block's");
    assert_eq!(after(&|params| params.stage[0].gain = -7.1), 7);
    assert_eq!(after(&|params| params.stage[0].filter[0].bandpass[0].a2 = 1.0), 7, "a pole on the unit circle");
    assert_eq!(after(&|params| params.stage[0].filter[0].bandpass[0].a1 = -2.0), 7);
    assert_eq!(sets::refusal(&coeffs, &Params { set_id: 0, ..whole }), 6);
    assert_eq!(sets::refusal(&coeffs, &Params { set_id: whole.set_id ^ 1, ..whole }), 8);
    let mut damaged = whole;
    damaged.stage[0].gain *= 0.5;
    assert_eq!(sets::refusal(&coeffs, &damaged), 8);
}
