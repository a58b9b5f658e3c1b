//! Weights and limit that the caller tunes: random inputs every cycle through every engine, and how far the output may step.

use axgen_tests::engines::agree;
use axgen_tests::environment::by_depth;
use axgen_tests::model::subject;
use axgen_tests::random::rng::Rng;
use axgen_tests::subject::Subject;
use compiler::leaves;
use compiler::program::Type;
use generator::blocks::{Designed, blocks};
use golden::engine::{self, Engine};
use golden::samples::{Samples, Shape};
use machine::closed_loop::Signals;
use portable::{Block, Literal, Portable, Real, RealKind};
use rayon::prelude::*;
use reference::ipc::{self, Ipc};

/// Cycles of a run.
const RUN: usize = 20_000;

/// Cycles of a run through all engines.
fn cycles() -> usize {
    RUN * by_depth(1, 3, 13)
}

/// An axis with three stages and everything that ipc may have, and one with a whole axis around it.
fn axis(real: RealKind, more: &str) -> Designed {
    let real = if real == RealKind::F64 { "f64" } else { "f32" };
    subject::read(&format!(
        "cycle_time = '1ms'
[axis.X]
real = '{real}'
fade = '30ms'
tunable = 'weights'
getriebe = [{{ kv = 2000, dynamik.vb_max = 500000 }}]
{more}
[axis.X.lr_param.improved_position_control]
enable = 'ON'
v_add_max_fact = 20
stage = [
    {{ mode = 'DIRECT', weight_fact_num = 3, filter = [{{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }}] }},
    {{ mode = 'INDIRECT', osc_damping = 0.8, tuning_weight = 0.5, filter = [{{ order = 2, prototype = 'BESSEL', fg_f0 = 41.0, q_factor = 2.0 }}] }},
    {{ mode = 'SET_POINT', osc_damping = 0.4, tuning_weight = 0, filter = [{{ order = 1, fg_f0 = 37.0, q_factor = 4.0 }}] }},
]
"
    ))
}

fn real(value: f64, real: RealKind) -> Literal {
    match real {
        RealKind::F64 => Literal::F64(value),
        RealKind::F32 => Literal::F32(f32::lit(value)),
    }
}

/// Something new in every cycle: parts in and out of their range and no numbers, vibrations, now and then anything else.
fn samples(shape: Shape) -> Samples {
    let mut rng = Rng::new(0);
    let mut modes = Rng::new(1);
    let mut uniform = move || (rng.word() >> 11) as f64 / 2f64.powi(53);
    let kind = shape.real;
    let mut samples = Samples::with_capacity(shape, cycles());
    let mut tuned = [0.0; 4];
    let mut mode = 1;
    for cycle in 0..cycles() {
        // A stretch in which every input moves each cycle, one in which they seldom do.
        let often = if cycle / 1000 % 2 == 0 { 1.0 } else { 0.02 };
        for part in &mut tuned {
            if uniform() < often {
                let which = uniform();
                *part = match () {
                    () if which < 0.02 => f64::NAN,
                    () if which < 0.04 => 1.0 + uniform(),
                    () if which < 0.06 => -uniform(),
                    () if which < 0.08 => uniform() * 1e-6,
                    () if which < 0.1 => f64::INFINITY,
                    () if which < 0.3 => 1.0,
                    () if which < 0.4 => 0.0,
                    () => uniform(),
                };
            }
        }
        if uniform() < 0.002 {
            mode = *modes.pick(&[0, 1, 1, 1, 2, 3]);
        }
        let vibration = 4e4 * (cycle as f64 * 0.31).sin() + 2e4 * uniform();
        let values: Vec<Literal> = samples
            .shape
            .signals
            .iter()
            .map(|signal| match (signal.name.as_str(), signal.ty) {
                ("tuning_weight[0]", _) => real(tuned[0], kind),
                ("tuning_weight[1]", _) => real(tuned[1], kind),
                ("tuning_weight[2]", _) => real(tuned[2], kind),
                ("tuning_limit", _) => real(tuned[3], kind),
                ("mode", _) => Literal::I32(mode),
                ("reset", _) => Literal::Bool(uniform() < 0.001),
                ("position_controlled", _) => Literal::Bool(uniform() > 0.001),
                (_, Type::Real) if uniform() < 0.0005 => real(f64::NAN, kind),
                (_, Type::Real) => real(vibration * (1.0 + 0.1 * uniform()), kind),
                _ => signal.start,
            })
            .collect();
        samples.push(&values);
    }
    samples
}

#[test]
fn random_tuning_in_every_cycle_gives_the_same_bits_in_every_engine() {
    let whole = "ride_through = 2\nvorsteuer.vorsteuerung = 'VEL'\n";
    let kinds = [RealKind::F64, RealKind::F32];
    let axes: Vec<Designed> = ["", whole].iter().flat_map(|more| kinds.map(|real| axis(real, more))).collect();
    let all: usize = axes
        .par_iter()
        .map(|designed| {
            let mut cycles = 0;
            let is_tuned = |name: &str| name == "ipc" || name == "axis";
            for block in blocks(designed).unwrap().iter().filter(|block| is_tuned(block.program.block)) {
                let inputs = samples(Shape::of(&block.program.inputs, block.program.real));
                let expected = engine::run(Engine::Reference, designed, block, &inputs).unwrap();
                has_held_and_acted(&expected);
                if block.program.block == "ipc" {
                    match designed.axis.real {
                        RealKind::F64 => is_what_any_cycle_does::<f64>(designed, &inputs, &expected),
                        RealKind::F32 => is_what_any_cycle_does::<f32>(designed, &inputs, &expected),
                    }
                }
                let name = format!("{} in {:?}", block.program.block, block.program.real);
                agree(&name, designed, block, &inputs, &expected);
                cycles += inputs.len();
            }
            cycles
        })
        .sum();
    eprintln!("{all} cycles with random tuning in every engine: 0 differing bits");
    assert!(all >= 5 * cycles());
}

/// The block begins with the usual cycle, and does what any cycle does.
fn is_what_any_cycle_does<R: Real>(designed: &Designed, inputs: &Samples, expected: &Samples)
where
    Ipc: Block<R, Coeffs = ipc::Coeffs<R>, State = ipc::State<R>, Inputs = ipc::Inputs<R>, Outputs = ipc::Outputs<R>>,
{
    let kind = generator::blocks::named("ipc").expect("the registry has it");
    let mut coefficients = kind.coefficients(designed).into_iter();
    let coeffs = ipc::Coeffs::<R>::build(&mut || coefficients.next().expect("all of them"));
    let (mut state, mut outputs) = (<Ipc as Block<R>>::state(), ipc::Outputs::<R>::default());
    let [mut given, mut wanted] = [const { Vec::new() }; 2];
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut given);
        expected.read(sample, &mut wanted);
        let mut next = given.iter();
        let now = ipc::Inputs::<R>::build(&mut || *next.next().expect("all of them"));
        ipc::any_cycle(&mut state, &coeffs, &now, &mut outputs);
        assert_eq!(leaves(&outputs), wanted, "{:?}, sample {sample}", designed.axis.real);
    }
}

/// Held inputs are told, and are no fault; the block acts in most cycles.
fn has_held_and_acted(outputs: &Samples) {
    let position = |name: &str| outputs.shape.signals.iter().position(|of| of.name == name).expect("an output of ipc");
    let [fault, error_id, v_add] = ["fault", "error_id", "v_add"].map(position);
    let (mut values, mut held, mut acted) = (Vec::new(), 0, 0);
    for sample in 0..outputs.len() {
        outputs.read(sample, &mut values);
        held += usize::from(values[error_id] == Literal::U32(4) && values[fault] == Literal::Bool(false));
        acted += usize::from(!matches!(values[v_add], Literal::F64(0.0) | Literal::F32(0.0)));
        assert!(
            values[error_id] != Literal::U32(4) || values[fault] == Literal::Bool(false),
            "a held input is no fault"
        );
    }
    let all = outputs.len();
    assert!(held > all / 20 && acted > all / 4, "{held} held, {acted} acted of {all}");
}

/// v_stage moves by at most |v_stage| / fade_cycles next to its own motion, whatever the input does (docs/improved-position-control.md).
#[test]
fn a_tuned_output_steps_no_further_than_its_ramp() {
    const FADE_CYCLES: f64 = 50.0;
    for kind in [RealKind::F64, RealKind::F32] {
        let name = if kind == RealKind::F64 { "f64" } else { "f32" };
        let set = |tunable: &str| {
            subject::read(&format!(
                "cycle_time = '1ms'\n[axis.X]\nreal = '{name}'\nfade = '50ms'\ntunable = '{tunable}'\ngetriebe = [{{ dynamik.vb_max = 500000 }}]
lr_param.improved_position_control = {{ enable = 'ON', v_add_max_fact = 2000, stage = [{{ mode = 'DIRECT', weight_fact_num = 3, filter = [{{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }}] }}] }}"
            ))
        };
        let runs = ["nothing", "weights"].map(|tunable| {
            let mut rng = Rng::new(3);
            let mut block = Subject::new(&set(tunable));
            let cycle = |cycle: usize| {
                let any = rng.below(1000) as f64 / 999.0;
                // The limit stays: where it acts, it is what cuts.
                block.set("tuning_weight[0]", if cycle.is_multiple_of(7) { f64::NAN } else { any.round() });
                block.step(&Signals { v_motor: 1e4 * (cycle as f64 * 0.333).sin(), ..Signals::default() })
            };
            (0..RUN).map(cycle).collect::<Vec<f64>>()
        });
        let [constant, tuned] = &runs;
        let of_rounding = if kind == RealKind::F64 { 1e-9 } else { 1e-2 };
        let mut largest_of_ramp: f64 = 0.0;
        for (own, now) in constant.windows(2).zip(tuned.windows(2)).skip(100) {
            let own_motion = (own[1] - own[0]).abs();
            let of_ramp = own[0].abs().max(own[1].abs()) / FADE_CYCLES;
            let step = (now[1] - now[0]).abs();
            assert!(step <= own_motion + of_ramp + of_rounding, "{name}: {step} above {own_motion} + {of_ramp}");
            largest_of_ramp = largest_of_ramp.max(step - own_motion);
        }
        assert!(largest_of_ramp > 0.0, "{name}: the ramp shows somewhere");
    }
}
