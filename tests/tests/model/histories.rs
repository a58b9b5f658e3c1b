//! What random histories of a spindle reach, and that a block with a mistake does not get through them. The model itself is
//! checked by the block, whose rules `tests/spindle` asserts one by one: where they differ, a history says so.

use axgen_tests::model::spindle::{Inputs, Model, Outputs, Parameters, agree, agree::compare, history};
use axgen_tests::random::rng::Rng;
use std::collections::BTreeMap;

/// Of a cycle's inputs, of parameters, of outputs.
type Change<T> = fn(&mut T);

/// From which state to which: all that there is, drive off and reset included.
const CHANGES: [(i32, &[i32]); 5] = [(0, &[0, 1, 3, 4]), (1, &[2, 4]), (2, &[2, 3, 4]), (3, &[3, 4]), (4, &[0, 3, 4])];
const CHANGES_OF_THE_DRIVE: [(i32, &[i32]); 2] = [(1, &[1, 3]), (4, &[2])];

/// The errors of each state.
const ERRORS: [(i32, &[u32]); 5] = [
    (0, &[1, 14, 17, 31, 32, 33, 34, 35, 46]),
    (1, &[14, 17]),
    (2, &[1, 14, 31, 32, 33, 34]),
    (3, &[1, 18, 23, 31, 32, 33, 34, 35, 42]),
    (4, &[1, 18, 23, 36]),
];
const ERRORS_OF_THE_DRIVE: [(i32, &[u32]); 5] =
    [(0, &[44, 45]), (1, &[1, 31, 35, 41, 44]), (2, &[45, 49]), (3, &[41]), (4, &[35, 43, 47])];

/// What began by missing samples in each state: the error, and whether it stayed; 46 is a take-over that failed after them.
const MISSED: [(i32, &[(u32, bool)]); 3] = [
    (0, &[(14, false), (14, true), (17, false), (17, true), (46, false)]),
    (1, &[(17, false)]),
    (2, &[(14, false), (14, true)]),
];
const MISSED_BY_THE_DRIVE: [(i32, &[(u32, bool)]); 3] =
    [(0, &[(45, false), (45, true)]), (1, &[(17, true)]), (2, &[(45, false), (45, true)])];
const MISSED_BY_THE_CNC: [(i32, &[(u32, bool)]); 1] = [(0, &[(18, false), (18, true)])];

/// The jobs of each state.
const JOBS: [(i32, &[i32]); 4] = [(0, &[0, 1, 2, 3, 4]), (1, &[1]), (2, &[0, 1]), (3, &[0])];

const SEEDS: u64 = 1500;
const CYCLES: usize = 3000;

fn parameters(seed: u64) -> Parameters {
    match seed % 5 {
        0 => Parameters::example(),
        1 => Parameters { in_cnc: true, feedforward: Some(0.8), ..Parameters::example() },
        _ => Parameters::random(&mut Rng::numbered(7, usize::try_from(seed).expect("small"))),
    }
}

#[test]
fn all_states_all_changes_and_all_errors_are_reached_in_the_drive_and_in_the_cnc() {
    let mut changes = BTreeMap::<(bool, i32, i32), u32>::new();
    let mut errors = BTreeMap::<(bool, i32, u32), u32>::new();
    let mut jobs = BTreeMap::<(bool, i32, i32), u32>::new();
    // What began by missing samples: the state, the error, whether it stayed; and a take-over that failed after them.
    let mut missed = BTreeMap::<(bool, i32, u32, bool), u32>::new();
    let mut limited = 0;
    for seed in 0..SEEDS {
        let p = parameters(seed);
        let mut model = Model::new(&p);
        let mut before = Outputs::START;
        let mut in_a_row = 0;
        for inputs in history(seed, CYCLES, &p) {
            let out = model.cycle(&inputs);
            *changes.entry((p.in_cnc, before.spindle_state, out.spindle_state)).or_default() += 1;
            *errors.entry((p.in_cnc, out.spindle_state, out.error_id)).or_default() += 1;
            *jobs.entry((p.in_cnc, out.spindle_state, out.job)).or_default() += 1;
            limited += u32::from(out.limited);
            assert!((0.0..360_000.0).contains(&out.x_spindle) && out.v_spindle.is_finite(), "seed {seed}: {out:?}");
            let misses = out.spindle_state <= 2 && matches!(out.error_id, 14 | 17 | 18 | 45);
            if misses && in_a_row == 4 {
                *missed.entry((p.in_cnc, out.spindle_state, out.error_id, true)).or_default() += 1;
            } else if !misses && (1..4).contains(&in_a_row) && before.spindle_state == out.spindle_state {
                let id = if out.error_id == 46 { 46 } else { before.error_id };
                *missed.entry((p.in_cnc, out.spindle_state, id, false)).or_default() += 1;
            }
            in_a_row = if misses { in_a_row + 1 } else { 0 };
            before = out;
        }
    }
    let mut missing = Vec::new();
    for in_cnc in [false, true] {
        let mut found = |what: String, count: Option<&u32>, least| {
            if count.is_none_or(|count| *count < least) {
                missing.push(format!("{what}, {in_cnc}"));
            }
        };
        let drive = |number: usize| if in_cnc { 0 } else { number };
        for (from, to) in pairs(&[&CHANGES, &CHANGES_OF_THE_DRIVE[..drive(2)]]) {
            found(format!("change {from} {to}"), changes.get(&(in_cnc, from, to)), 10);
        }
        for (state, id) in pairs(&[&ERRORS, &ERRORS_OF_THE_DRIVE[..drive(5)]]) {
            found(format!("error {id} in {state}"), errors.get(&(in_cnc, state, id)), 2);
        }
        let more: &[_] = if in_cnc { &MISSED_BY_THE_CNC } else { &MISSED_BY_THE_DRIVE };
        for (state, (id, stays)) in pairs(&[&MISSED, more]) {
            let count = missed.get(&(in_cnc, state, id, stays));
            found(format!("missing sample {id} in {state}, stays: {stays}"), count, 2);
        }
        for (state, job) in pairs(&[&JOBS]) {
            found(format!("job {job} in {state}"), jobs.get(&(in_cnc, state, job)), 10);
        }
    }
    eprintln!("changes {changes:?}\nerrors {errors:?}\njobs {jobs:?}\nlimited {limited}\nmissed {missed:?}");
    assert!(missing.is_empty() && limited > 10, "limited {limited}, missing {missing:#?}");
}

/// Each state of these tables with each of its entries.
fn pairs<T: Copy>(tables: &[&[(i32, &[T])]]) -> Vec<(i32, T)> {
    let rows = tables.iter().flat_map(|table| table.iter());
    rows.flat_map(|(state, entries)| entries.iter().map(|entry| (*state, *entry))).collect()
}

#[test]
fn a_history_is_the_same_each_time_and_the_model_agrees_with_itself() {
    for seed in 0..10 {
        let p = parameters(seed);
        let of = |seed| format!("{:?}", history(seed, 500, &p));
        assert_eq!(of(seed), of(seed));
        assert_ne!(of(seed), of(seed + 1));
        let mut block = Model::new(&p);
        agree(&p, seed, CYCLES, |inputs| block.cycle(inputs)).expect("the model agrees with itself");
    }
}

/// Whether a block of other parameters, or one that alters inputs and outputs, is found within some seeds.
fn is_found(name: &str, other: impl Fn(&mut Parameters), altered: impl Fn(&mut Inputs), told: impl Fn(&mut Outputs)) {
    let found = (0..60).any(|seed| {
        let p = parameters(seed);
        let mut wrong = p.clone();
        other(&mut wrong);
        let mut block = Model::new(&wrong);
        let block = |inputs: &Inputs| {
            let mut inputs = *inputs;
            altered(&mut inputs);
            let mut out = block.cycle(&inputs);
            told(&mut out);
            out
        };
        agree(&p, seed, CYCLES, block).is_err()
    });
    assert!(found, "{name} is not found");
}

#[test]
fn a_block_with_a_mistake_is_found() {
    let parameters: [(&str, Change<Parameters>); 15] = [
        ("closes_loop", |p| p.closes_loop = p.in_cnc && !p.closes_loop),
        ("only_position", |p| p.only_position = !p.in_cnc && !p.only_position),
        ("nd", |p| p.nd += 1),
        ("w", |p| p.w += 1e-6),
        ("kv", |p| p.kv *= 1.0 + 1e-6),
        ("feedforward", |p| p.feedforward = p.feedforward.map(|weight| weight + 1e-6)),
        ("deceleration", |p| p.deceleration *= 1.0 + 1e-6),
        ("v_on", |p| p.v_on += 10.0),
        ("v_off", |p| p.v_off += 1.0),
        ("window", |p| p.window *= 1.05),
        ("mode_timeout", |p| p.mode_timeout_cycles += 1),
        ("brake_timeout", |p| p.brake_timeout_cycles -= 1),
        ("takeover_window", |p| p.takeover_window *= 1.3),
        ("velocity_scale", |p| p.velocity_scale *= 1.000_001),
        ("velocity_range", |p| p.velocity_range[1] -= 1),
    ];
    for (name, other) in parameters {
        is_found(name, other, |_| {}, |_| {});
    }
    let inputs: [(&str, Change<Inputs>); 6] = [
        ("percentage", |i| i.feedforward_percentage = 100),
        ("sign of s_word", |i| i.s_word = i.s_word.abs() + 1e-3),
        ("reset", |i| i.reset = false),
        ("x_actual out of range", |i| i.x_actual = i.x_actual.clamp(-7e14, 7e14)),
        ("v_actual out of range", |i| i.v_actual = if i.v_actual.is_nan() { 0.0 } else { i.v_actual }),
        ("task_cycle_ns", |i| i.task_cycle_ns = 0),
    ];
    for (name, altered) in inputs {
        is_found(name, |_| {}, altered, |_| {});
    }
    let outputs: [(&str, Change<Outputs>); 6] = [
        ("x_spindle", |o| o.x_spindle += 1e-3 + f64::EPSILON),
        ("x_spindle on the circle", |o| o.x_spindle += 360_000.0),
        ("x_spindle no number", |o| o.x_spindle = f64::NAN),
        ("v_spindle", |o| o.v_spindle += 1e-3),
        ("limited", |o| o.limited = false),
        ("loop_closed", |o| o.loop_closed = o.spindle_state == 0),
    ];
    for (name, told) in outputs {
        is_found(name, |_| {}, |_| {}, told);
    }
}

#[test]
fn a_difference_names_the_cycle_the_signal_and_both_values() {
    let p = Parameters::example();
    let history = history(1, 5, &p);
    let mut block = Model::new(&p);
    let text = compare(&p, &history, |inputs| Outputs { job: 9, ..block.cycle(inputs) }).expect_err("another job");
    assert!(text.starts_with("cycle 0: job: the model has 0, the block 9\n"), "{text}");
    let mut block = Model::new(&p);
    let text = agree(&p, 3, 5, |inputs| Outputs { v_spindle: 0.5, ..block.cycle(inputs) }).expect_err("another v");
    assert!(text.starts_with("seed 3: cycle 0: v_spindle: the model has "), "{text}");
    assert!(text.contains(", the block 0.5\n"), "{text}");
}
