//! States that something else has overwritten, in double and in single precision: what is not a number is a fault with an id
//! and a fresh start, anything else decays; the limit holds all the while.

use axgen_tests::environment::by_depth;
use axgen_tests::model::subject;
use axgen_tests::random::overwritten::flipped;
use axgen_tests::random::rng::Rng;
use compiler::leaves;
use generator::blocks;
use portable::{Block, Literal, Portable, Real, scalar};
use rayon::prelude::*;
use reference::ipc::{self, Ipc};
use reference::signal::error_state;
use std::f64::consts::{PI, TAU};

const CYCLE: f64 = 0.001;
/// The slowest section: 20 Hz, Q 5.
const TIME_CONSTANT: f64 = 5.0 / (PI * 20.0);
/// Cycles before the state is overwritten, and after it until nothing of it may be left.
const BEFORE: usize = 300;
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
const LASTS: usize = (10.0 * TIME_CONSTANT / CYCLE) as usize;
/// Cycles in which the outputs are compared then.
const COMPARED: usize = 200;
/// What may be left, as a part of the largest output.
const LEFT: f64 = 1e-3;

fn set(real: &str, tunable: &str) -> String {
    format!(
        "cycle_time = '1ms'\n[axis.X]\nreal = '{real}'\ntunable = '{tunable}'\ngetriebe = [{{ dynamik.vb_max = 500000 }}]
[axis.X.lr_param.improved_position_control]\nenable = 'ON'\nv_add_max_fact = 200
[[axis.X.lr_param.improved_position_control.stage]]\nmode = 'DIRECT'
filter = [{{ order = 1, fg_f0 = 20.0, q_factor = 5.0 }}]
[[axis.X.lr_param.improved_position_control.stage]]\nmode = 'INDIRECT'\nosc_damping = 0.5
filter = [{{ order = 1, fg_f0 = 50.0, q_factor = 2.0 }}]
[[axis.X.lr_param.improved_position_control.stage]]\nmode = 'DIRECT'
filter = [{{ type = 'ALLPASS', fg_f0 = 30.0, q_factor = 2.0 }}, {{ type = 'BANDPASS', prototype = 'CRIT_DAMPING', order = 1, fg_f0 = 40.0, q_factor = 2.0 }}]
"
    )
}

/// Overwrites one value of the state that the axis uses: a real with a NaN or an infinity, any with one of its bits the other way
/// round. Gives whether it is a number then.
fn disturb<R: Real>(state: &ipc::State<R>, rng: &mut Rng) -> (ipc::State<R>, bool) {
    let mut all = leaves(state);
    // A real that is 0 after a vibration belongs to a section that the axis does not have.
    let is_used = |of: &Literal| match of {
        Literal::F64(value) => *value != 0.0,
        Literal::F32(value) => *value != 0.0,
        _ => true,
    };
    let used: Vec<usize> = (0..all.len()).filter(|at| is_used(&all[*at])).collect();
    let at = *rng.pick(&used);
    let (kind, bit) = (rng.below(8), rng.below(64));
    let no_number = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY].get(kind).copied();
    all[at] = match (all[at], no_number) {
        (Literal::F64(_) | Literal::F32(_), Some(value)) => scalar(&R::lit(value)),
        (value, _) => flipped(value, bit),
    };
    let is_number = match all[at] {
        Literal::F64(value) => value.is_finite(),
        Literal::F32(value) => value.is_finite(),
        _ => true,
    };
    let mut all = all.into_iter();
    (Portable::build(&mut || all.next().expect("all of the state")), is_number)
}

/// Whether a disturbance came up as a fault. Nothing of it is left after ten time constants, and the limit always holds.
fn run<R: Real>(coeffs: &ipc::Coeffs<R>, seed: u64) -> bool
where
    ipc::State<R>: Copy,
{
    let mut rng = Rng::new(seed);
    // The axis reaches 400 mm/s in 0.2 s, and vibrates so much that the block uses most of its limit.
    let velocity = |n: usize| {
        let vibration = 45_000.0 * (TAU * 21.0 * CYCLE * n as f64).sin();
        R::lit(400_000.0 * (n as f64 / 200.0).min(1.0) + vibration)
    };
    let mut inputs = <Ipc as Block<R>>::inputs(coeffs);
    let mut state = <Ipc as Block<R>>::state();
    let mut outputs = <Ipc as Block<R>>::outputs();
    let mut peak = 0.0_f64;
    for n in 0..BEFORE {
        inputs.v_motor = velocity(n);
        ipc::step(&mut state, coeffs, &inputs, &mut outputs);
        peak = peak.max(outputs.v_add.to_f64().abs());
    }
    let limit = coeffs.limit.to_f64();
    assert!(peak > 0.5 * limit && peak < limit, "{peak} of {limit}");
    let (mut other, is_number) = disturb(&state, &mut rng);
    let (mut fault, mut left) = (None, 0.0_f64);
    for n in BEFORE..BEFORE + LASTS + COMPARED {
        inputs.v_motor = velocity(n);
        ipc::step(&mut state, coeffs, &inputs, &mut outputs);
        let undisturbed = outputs.v_add.to_f64();
        ipc::step(&mut other, coeffs, &inputs, &mut outputs);
        let disturbed = outputs.v_add.to_f64();
        assert!(disturbed.abs() <= limit, "seed {seed}, cycle {n}: {disturbed}");
        if outputs.fault {
            assert_eq!(outputs.error_id, error_state(), "seed {seed}, cycle {n}");
            assert_eq!(disturbed.to_bits(), 0, "seed {seed}, cycle {n}");
            fault.get_or_insert(n - BEFORE);
        }
        if n >= BEFORE + LASTS {
            left = left.max((disturbed - undisturbed).abs());
        }
    }
    // A state reaches the sum through at most two sections of two states, and the fault comes in the cycle after. A part
    // that is tuned is found before it is used, and moves back to its input.
    assert!(is_number || coeffs.tuning.active || fault.is_some_and(|cycles| cycles <= 6), "seed {seed}: {fault:?}");
    assert!(left <= LEFT * peak, "seed {seed}: fault {fault:?}, {left} of {peak} is left");
    fault.is_some()
}

/// How many disturbances were faults.
fn faults<R: Real + Send + Sync>(real: &str, tunable: &str, count: u64) -> usize
where
    ipc::State<R>: Copy,
    ipc::Coeffs<R>: Sync,
{
    let designed = subject::read(&set(real, tunable));
    let kind = blocks::named("ipc").expect("the registry has the block");
    let mut all = kind.coefficients(&designed).into_iter();
    let coeffs: ipc::Coeffs<R> = Portable::build(&mut || all.next().expect("all coefficients"));
    (0..count).into_par_iter().filter(|seed| run(&coeffs, *seed)).count()
}

#[test]
fn an_overwritten_state_is_a_fault_or_decays() {
    let count = by_depth(1_000, 1_500, 10_000);
    for tunable in ["nothing", "weights"] {
        for (real, faults) in
            [("f64", faults::<f64>("f64", tunable, count)), ("f32", faults::<f32>("f32", tunable, count))]
        {
            eprintln!("{real}, {tunable} tuned: of {count} disturbances {faults} are faults, the others decay");
            assert!(faults as u64 * 5 > count, "{real}: {faults}");
        }
    }
}
