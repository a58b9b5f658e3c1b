//! States that something else has overwritten, in double and in single precision: what is no number is a fault with an id and a fresh start, anything else
//! decays; the limit holds all the while.

use axgen_tests::environment::is_exhaustive;
use axgen_tests::model::subject;
use axgen_tests::random::rng::Rng;
use compiler::leaves;
use generator::blocks;
use portable::{Block, Literal, Portable, Real};
use rayon::prelude::*;
use reference::ipc::{self, Ipc};
use reference::signal::error_state;
use std::f64::consts::{PI, TAU};

const CYCLE: f64 = 0.001;
/// The slowest section: 20 Hz, Q 5, a Butterworth pair.
const TIME_CONSTANT: f64 = 1.5 * 5.0 / (PI * 20.0);
/// Cycles before the state is overwritten, and behind it until nothing of it may be left.
const BEFORE: usize = 300;
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
const LASTS: usize = (10.0 * TIME_CONSTANT / CYCLE) as usize;
/// Cycles in which the outputs are compared then.
const COMPARED: usize = 200;
/// What may be left, as a part of the largest output.
const LEFT: f64 = 1e-3;

fn set(real: &str) -> String {
    format!(
        "cycle_time = '1ms'\n[axis.X]\nreal = '{real}'\ngetriebe = [{{ dynamik.vb_max = 500000 }}]
[axis.X.lr_param.improved_position_control]\nenable = 'ON'\nv_add_max_fact = 100
[[axis.X.lr_param.improved_position_control.stage]]\nmode = 'DIRECT'
filter = [{{ prototype = 'BUTTERWORTH', order = 2, fg_f0 = 20.0, q_factor = 5.0 }}]
[[axis.X.lr_param.improved_position_control.stage]]\nmode = 'INDIRECT'\nosc_damping = 0.5
filter = [{{ order = 1, fg_f0 = 50.0, q_factor = 2.0 }}]
[[axis.X.lr_param.improved_position_control.stage]]\nmode = 'DIRECT'
filter = [{{ type = 'ALLPASS', fg_f0 = 30.0, q_factor = 2.0 }}, {{ type = 'BANDPASS', prototype = 'CRIT_DAMPING', order = 1, fg_f0 = 40.0, q_factor = 2.0 }}]
"
    )
}

/// Overwrites one real of the state that the axis uses: with a NaN, an infinity, or with one of its bits the other way round. Gives whether it is a number then.
fn disturb<R: Real>(state: &ipc::State<R>, rng: &mut Rng) -> (ipc::State<R>, bool) {
    let mut all = leaves(state);
    // What is 0 behind a vibration belongs to a section that the axis does not have.
    let is_used = |of: &Literal| match of {
        Literal::F64(value) => *value != 0.0,
        Literal::F32(value) => *value != 0.0,
        _ => false,
    };
    let reals: Vec<usize> = (0..all.len()).filter(|at| is_used(&all[*at])).collect();
    let at = *rng.pick(&reals);
    let kind = rng.below(8);
    let bit = rng.below(64);
    let is_number;
    all[at] = match all[at] {
        Literal::F64(value) => {
            let value = match kind {
                0 => f64::NAN,
                1 => f64::INFINITY,
                2 => f64::NEG_INFINITY,
                _ => f64::from_bits(value.to_bits() ^ 1 << bit),
            };
            is_number = value.is_finite();
            Literal::F64(value)
        }
        Literal::F32(value) => {
            let value = match kind {
                0 => f32::NAN,
                1 => f32::INFINITY,
                2 => f32::NEG_INFINITY,
                _ => f32::from_bits(value.to_bits() ^ 1 << (bit % 32)),
            };
            is_number = value.is_finite();
            Literal::F32(value)
        }
        other => panic!("{other:?} is no real"),
    };
    let mut all = all.into_iter();
    (Portable::build(&mut || all.next().expect("all of the state")), is_number)
}

/// What came of one disturbance: whether there was a fault, and whether something of it is left.
fn run<R: Real>(coeffs: &ipc::Coeffs<R>, seed: u64) -> [bool; 2]
where
    ipc::State<R>: Copy,
{
    let mut rng = Rng::new(seed);
    let velocity = |n: usize| R::lit(2_000.0 * (TAU * 21.0 * CYCLE * n as f64).sin() + 50_000.0);
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
    assert!(peak > 100.0 && peak < limit, "{peak}");
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
        } else {
            // Where it was at the limit there is more to decay.
            peak = peak.max(disturbed.abs());
        }
    }
    // A state reaches the sum through at most two sections of two states, and the fault comes in the cycle behind.
    assert!(is_number || fault.is_some_and(|cycles| cycles <= 6), "seed {seed}: {fault:?}");
    let is_over = left <= LEFT * peak;
    assert!(is_over || fault.is_none(), "seed {seed}: {left} of {peak} is left behind a fault");
    [fault.is_some(), !is_over]
}

/// How many disturbances were faults, and of how many something is left.
fn run_all<R: Real + Send + Sync>(real: &str, count: u64) -> [usize; 2]
where
    ipc::State<R>: Copy,
    ipc::Coeffs<R>: Sync,
{
    let designed = subject::read(&set(real));
    let kind = blocks::named("ipc").expect("the registry has the block");
    let mut all = kind.coefficients(&designed).into_iter();
    let coeffs: ipc::Coeffs<R> = Portable::build(&mut || all.next().expect("all coefficients"));
    let came: Vec<[bool; 2]> = (0..count).into_par_iter().map(|seed| run(&coeffs, seed)).collect();
    [0, 1].map(|at| came.iter().filter(|of| of[at]).count())
}

/// A state that has become large, but not beyond what samples in range could lead to, holds the output at its limit until it has decayed.
#[test]
fn an_overwritten_state_is_a_fault_or_decays() {
    let count = if is_exhaustive() { 10_000 } else { 2_000 };
    for (real, [faults, left]) in [("f64", run_all::<f64>("f64", count)), ("f32", run_all::<f32>("f32", count))] {
        eprintln!(
            "{real}: of {count} disturbances {faults} are faults, of {left} something is left after ten time constants"
        );
        assert!(faults as u64 * 4 > count, "{real}: {faults}");
        assert!(left as u64 * 20 < count, "{real}: {left}");
    }
}
