//! Blocks that are not called once in each cycle: what a wrong rate makes of improved position control where nobody
//! looks, after how many cycles it is a fault where the axis has the key `cycle_counter`, and what a block does after
//! a pause.

use axgen_tests::model::calls::Calls;
use axgen_tests::model::subject;
use axgen_tests::random::rng::Rng;
use compiler::leaves;
use generator::blocks::{self, Designed};
use portable::{Block, Portable};
use reference::{axis, feedforward, ipc, position_control, sets, spindle, tunable_ipc};
use std::f64::consts::TAU;

/// The centre frequency of the stage, in periods a cycle.
const FREQUENCY: f64 = 0.053;
const FADE_CYCLES: u32 = 100;

/// An axis that adds its own vibration with 180 degrees and gain 1.
fn read(more: &str) -> Designed {
    subject::read(&format!(
        "cycle_time = '1ms'
[axis.X]
getriebe = [{{ kv = 2000, dynamik.vb_max = 500000 }}]
{more}
[axis.X.lr_param.improved_position_control]
enable = 'ON'
v_add_max_fact = 1000
stage = [{{ mode = 'DIRECT', filter = [{{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }}] }}]
"
    ))
}

/// A block with its inputs.
struct Bench<B: Block<f64>> {
    coeffs: B::Coeffs,
    state: B::State,
    inputs: B::Inputs,
}

impl<B: Block<f64>> Bench<B> {
    fn new(designed: &Designed) -> Self {
        let kind = blocks::of_axis(&designed.axis).find(|kind| kind.name() == B::NAME).expect("the axis has the block");
        let mut leaves = kind.coefficients(designed).into_iter();
        let coeffs: B::Coeffs = Portable::build(&mut || leaves.next().expect("all coefficients"));
        let mut inputs = B::inputs(&coeffs);
        B::exercise(&mut inputs, &coeffs);
        Self { state: B::state(), inputs, coeffs }
    }

    fn call(&mut self) -> B::Outputs {
        let mut outputs = B::outputs();
        B::step(&mut self.state, &self.coeffs, &self.inputs, &mut outputs);
        outputs
    }
}

fn vibration(cycle: u32) -> f64 {
    (TAU * FREQUENCY * f64::from(cycle)).sin()
}

/// A wrong rate: how often the block is called in a cycle.
type Rate = fn(u32) -> u32;

/// What `v_add` is to the vibration: gain, and phase in degrees; and the first cycle with a fault.
fn response(more: &str, rate: Rate) -> (f64, f64, Option<u32>) {
    const FIRST: u32 = 8000;
    const LAST: u32 = 10_000;
    let mut block = Bench::<ipc::Ipc>::new(&read(more));
    let (mut real, mut imaginary, mut v_add, mut fault) = (0.0, 0.0, 0.0, None);
    for cycle in 1..=LAST {
        (block.inputs.v_motor, block.inputs.cycle_counter) = (1000.0 * vibration(cycle), cycle);
        for _ in 0..rate(cycle) {
            let outputs = block.call();
            v_add = outputs.v_add;
            if outputs.fault {
                assert_eq!((outputs.error_id, outputs.v_add), (9, 0.0));
                fault = fault.or(Some(cycle));
            }
        }
        if cycle > FIRST {
            let (sine, cosine) = (TAU * FREQUENCY * f64::from(cycle)).sin_cos();
            (real, imaginary) = (real + v_add * sine, imaginary + v_add * cosine);
        }
    }
    let scale = 2.0 / f64::from(LAST - FIRST) / 1000.0;
    (scale * real.hypot(imaginary), imaginary.atan2(real).to_degrees(), fault)
}

#[test]
fn a_wrong_rate_turns_the_phase_and_is_a_fault_where_calls_are_counted() {
    let (gain, phase, _) = response("", |_| 1);
    assert!((gain - 1.0).abs() < 1e-3 && (phase.abs() - 180.0).abs() < 0.1, "as designed: {gain} at {phase}");
    let rates: [(&str, Rate, &str, u32); 3] = [
        ("twice", |_| 2, "0.07 at -89", 3),
        ("every second", |cycle| cycle % 2, "0.06 at 84", 5),
        ("one in four lost", |cycle| u32::from(cycle % 4 != 0), "0.17 at 97", 13),
    ];
    for (name, rate, becomes, cycles) in rates {
        let (gain, phase, fault) = response("", rate);
        assert_eq!(format!("{gain:.2} at {phase:.0}"), becomes, "{name}");
        assert_eq!(fault, None, "nobody looks");
        let (gain, _, fault) = response("cycle_counter = true", rate);
        assert_eq!((fault, gain), (Some(cycles), 0.0), "{name}: nothing is added any more");
    }
    let (gain, phase, fault) = response("cycle_counter = true", |_| 1);
    assert!((gain - 1.0).abs() < 1e-3 && (phase.abs() - 180.0).abs() < 0.1 && fault.is_none());
}

/// Runs a block until it acts, calls it no more while the axis comes to rest, and goes on. Gives what it puts out from then on.
fn behind_a_pause(block: &mut Bench<ipc::Ipc>) -> Vec<f64> {
    for cycle in 1..=1000 {
        (block.inputs.v_motor, block.inputs.cycle_counter) = (100_000.0 * vibration(cycle), cycle);
        block.call();
    }
    block.inputs.v_motor = 0.0;
    let resumed = (1101..1111).map(|cycle| {
        block.inputs.cycle_counter = cycle;
        block.call()
    });
    resumed.inspect(|outputs| assert!(!outputs.fault, "one pause is no fault")).map(|outputs| outputs.v_add).collect()
}

#[test]
fn a_block_goes_on_with_nothing_that_it_held_before_a_pause() {
    let held = behind_a_pause(&mut Bench::new(&read("")));
    assert!(held[1].abs() > 10_000.0, "{held:?}: that is what nobody looks at");
    assert_eq!(behind_a_pause(&mut Bench::new(&read("cycle_counter = true"))), [0.0; 10]);
}

/// A pause does not hide a corrupted state: the cycle after it reports the fault, and no set is in use.
#[test]
fn a_pause_hides_no_fault() {
    let mut block = Bench::<tunable_ipc::TunableIpc>::new(&read("cycle_counter = true\ntunable = 'all'"));
    for more in [1, 50] {
        let start = block.inputs.cycle_counter;
        for cycle in start + 1..start + 1000 {
            (block.inputs.v_motor, block.inputs.cycle_counter) = (1e4 * vibration(cycle), cycle);
            block.call();
        }
        block.state.ipc.stage[0].filter[0].section[0].s1 = 1e30;
        block.inputs.cycle_counter += 1;
        assert_eq!((block.call().v_add, block.state.own.set_id != 0), (0.0, true));
        block.inputs.cycle_counter += more;
        let outputs = block.call();
        assert_eq!((outputs.fault, outputs.error_id, outputs.active_set), (true, 3, 0), "{more} cycles later");
    }
}

/// A block that has paused puts out what a new one puts out.
fn assert_like_new<B: Block<f64>>(designed: &Designed, set: impl Fn(&mut B::Inputs, u32)) {
    let call = |block: &mut Bench<B>, cycle| {
        set(&mut block.inputs, cycle);
        leaves(&block.call())
    };
    let run = |block: &mut _, cycles: std::ops::Range<u32>| cycles.map(|cycle| call(block, cycle)).collect::<Vec<_>>();
    let (mut paused, mut other) = (Bench::<B>::new(designed), Bench::<B>::new(designed));
    assert_ne!(run(&mut paused, 1..500)[498], leaves(&B::outputs()), "it acts");
    assert_eq!(run(&mut paused, 503..800), run(&mut other, 503..800), "{}: three calls are missing", B::NAME);
    // Two are no pause.
    assert_ne!(run(&mut paused, 802..900), run(&mut Bench::<B>::new(designed), 802..900), "{}", B::NAME);
}

#[test]
fn every_block_starts_anew_behind_a_pause() {
    // Every part of an axis runs.
    let whole = read(include_str!("whole.toml"));
    assert_like_new::<feedforward::Feedforward>(&whole, |inputs, cycle| {
        inputs.v_interpolator = 1e5 * vibration(cycle);
        inputs.cycle_counter = cycle;
    });
    assert_like_new::<axis::Axis>(&whole, |inputs, cycle| {
        (inputs.x_command, inputs.v_interpolator) = (1e5 * f64::from(cycle), 1e5 * vibration(cycle));
        (inputs.v_motor, inputs.cycle_counter) = (1e4 * vibration(cycle), cycle);
    });
    for tunable in ["", "tunable = 'weights'"] {
        let designed = read(&format!("cycle_counter = true\n{tunable}"));
        let set = |inputs: &mut ipc::Inputs<f64>, cycle| {
            (inputs.v_motor, inputs.cycle_counter) = (1e4 * vibration(cycle), cycle);
        };
        assert_like_new::<ipc::Ipc>(&designed, set);
    }
}

/// Random calls: regular ones, such that are tolerated, faults, pauses.
fn counters(seed: u64, irregular: usize) -> impl Iterator<Item = u32> {
    let (mut rng, mut counter) = (Rng::new(seed), 0u32);
    std::iter::repeat_with(move || {
        let more = if rng.below(1000) < irregular { *rng.pick(&[0, 0, 2, 2, 3, 4, 90]) } else { 1 };
        counter = counter.wrapping_add(more);
        if rng.below(3000) == 0 {
            counter = *rng.pick(&[0, 1, u32::MAX - 500]);
        }
        counter
    })
}

/// The block `ipc` follows the rules of the document: its fault, and where it starts anew. The other parts of the
/// model say the rest.
#[test]
fn improved_position_control_follows_the_model_of_the_calls() {
    let designed = read("cycle_counter = true");
    let (mut faults, mut starts) = (0, 0);
    for seed in 0..100u64 {
        let irregular = [5, 50, 110, 300][usize::try_from(seed % 4).expect("small")];
        let (mut block, mut model) = (Bench::<ipc::Ipc>::new(&designed), Calls::default());
        let mut open = None;
        for (cycle, counter) in (0..3000).zip(counters(seed, irregular)) {
            (block.inputs.v_motor, block.inputs.cycle_counter) = (1e4 * vibration(cycle), counter);
            let outputs = block.call();
            let verdict = model.call(true, counter);
            let (fault, id) = (verdict.is_fault, if verdict.is_fault { 9 } else { 0 });
            assert_eq!((outputs.fault, outputs.error_id), (fault, id), "seed {seed}, cycle {cycle}, counter {counter}");
            open = match open {
                _ if verdict.is_fault => None,
                Some(open) if !verdict.restarts => Some(FADE_CYCLES.min(open + 1)),
                _ => Some(0),
            };
            let part = f64::from(open.unwrap_or(0)) / f64::from(FADE_CYCLES);
            let expected = part * outputs.v_add_calculated;
            assert!(
                (outputs.v_add - expected).abs() <= 1e-9 * expected.abs(),
                "seed {seed}, cycle {cycle}: the fade at {part}"
            );
            assert!(part > 0.0 || outputs.v_add_calculated == 0.0, "the sections are preset");
            (faults, starts) = (faults + u32::from(fault), starts + u32::from(verdict.restarts));
        }
    }
    assert!(faults > 10_000 && starts > 500, "{faults} faults, {starts} pauses");
}

/// The blocks that begin with the usual cycle do what any cycle does.
#[test]
fn usual_calls_are_like_any() {
    let weights = read("cycle_counter = true\ntunable = 'weights'");
    let all = read("cycle_counter = true\ntunable = 'all'");
    for seed in 0..20 {
        let mut tuned = Bench::<ipc::Ipc>::new(&weights);
        let mut sets = Bench::<tunable_ipc::TunableIpc>::new(&all);
        for (cycle, counter) in (0..3000).zip(counters(seed, 10)) {
            let v_motor = 1e4 * vibration(cycle);
            (tuned.inputs.v_motor, tuned.inputs.cycle_counter) = (v_motor, counter);
            (sets.inputs.v_motor, sets.inputs.cycle_counter) = (v_motor, counter);
            let (mut state, mut outputs) = (tuned.state, <ipc::Ipc as Block<f64>>::outputs());
            ipc::any_cycle(&mut state, &tuned.coeffs, &tuned.inputs, &mut outputs);
            assert_eq!(leaves(&tuned.call()), leaves(&outputs), "seed {seed}, cycle {cycle}");
            assert_eq!(leaves(&tuned.state), leaves(&state), "seed {seed}, cycle {cycle}");
            let (mut state, mut outputs) = (sets.state, <tunable_ipc::TunableIpc as Block<f64>>::outputs());
            sets::compare_one(&mut state.own, &mut state.ipc, &sets.coeffs);
            tunable_ipc::any_cycle(&mut state, &sets.coeffs, &sets.inputs, &mut outputs);
            assert_eq!(leaves(&sets.call()), leaves(&outputs), "seed {seed}, cycle {cycle}");
            assert_eq!(leaves(&sets.state), leaves(&state), "seed {seed}, cycle {cycle}");
        }
    }
}

/// A drive that gets a position: after a pause the delay of the position begins at the present one.
#[test]
fn position_control_starts_anew_behind_a_pause() {
    let designed = read(
        "cycle_counter = true\nkenngr.antr_typ = 'PROFIDRIVE'\nprocess_data.additive_velocity = 'INT32'\nvorsteuer.vorsteuerung = 'VEL'\n",
    );
    let mut block = Bench::<position_control::PositionControl>::new(&designed);
    for cycle in (1..300).chain(304..400) {
        (block.inputs.x_command, block.inputs.cycle_counter) = (1000.0 * f64::from(cycle), cycle);
        let outputs = block.call();
        // Three cycles later than the command (P-AXIS-00165); at first, and after the pause, the oldest position that there is.
        let oldest = if cycle < 304 { 1 } else { 304 };
        let x = 1000.0 * f64::from(cycle.saturating_sub(3).max(oldest));
        assert_eq!((outputs.fault, outputs.x_drive), (false, x), "cycle {cycle}");
    }
    let faults = (400..440).map(|cycle| {
        (block.inputs.x_command, block.inputs.cycle_counter) = (1000.0 * f64::from(cycle), 400 + 2 * (cycle - 400));
        let outputs = block.call();
        let is_following = outputs.x_drive.to_bits() == (1000.0 * f64::from(cycle)).to_bits();
        assert_eq!(is_following, outputs.fault, "a fault lets the drive follow the command");
        outputs.error_id
    });
    assert_eq!(faults.collect::<Vec<_>>()[..4], [0, 0, 9, 9]);
}

/// A pause alone stops a spindle whose drive is on: from its actual velocity, with the deceleration of the
/// changeover, until reset.
#[test]
fn a_spindle_stops_behind_a_pause_without_a_jump() {
    let designed = subject::read(include_str!("spindle.toml"));
    let turning = || {
        let mut block = Bench::<spindle::Spindle>::new(&designed);
        for cycle in 1..200u32 {
            // It stands at first.
            let v = if cycle > 10 { 1e6 } else { 0.0 };
            block.inputs.x_command = 2000.0 * f64::from(cycle.saturating_sub(10)) % 360_000.0;
            (block.inputs.v_interpolator, block.inputs.v_actual) = (v, v);
            (block.inputs.x_actual, block.inputs.cycle_counter) = (block.inputs.x_command, cycle);
            assert_eq!(block.call().error_id, 0, "cycle {cycle}");
        }
        block
    };
    let mut block = turning();
    (block.inputs.cycle_counter, block.inputs.v_actual, block.inputs.x_actual) = (300, 9e5, 90_000.0);
    let (step, lead) = (block.coeffs.v_step, block.coeffs.lead_time);
    let first = block.call();
    assert_eq!((first.error_id, first.fault, first.loop_closed), (9, true, false));
    assert_eq!(first.v_spindle.to_bits(), (9e5 - step).to_bits(), "from the actual velocity on");
    let (x, mut v) = (90_000.0 + 9e5 * lead + first.v_spindle * 0.002, first.v_spindle);
    assert!((first.x_spindle - x).abs() < 1e-6, "{} and {x}: where the drive has its lag", first.x_spindle);
    for cycle in 301..600 {
        block.inputs.cycle_counter = cycle;
        let outputs = block.call();
        v = (v - step).max(0.0);
        assert_eq!((outputs.error_id, outputs.v_spindle), (9, v), "cycle {cycle}");
    }
    (block.inputs.reset, block.inputs.cycle_counter) = (true, 600);
    assert_eq!(block.call().error_id, 0, "a reset ends it");

    // A difference of positions over the whole pause is larger, or of another turn: it never accelerates or reverses the spindle.
    for (v_actual, v) in [(1.1e7, 1e6 - step), (9.1e7, 1e6 - step), (-9e6, 0.0), (f64::NAN, 1e6 - step)] {
        let mut block = turning();
        (block.inputs.cycle_counter, block.inputs.v_actual) = (300, v_actual);
        assert_eq!(block.call().v_spindle.to_bits(), v.to_bits());
    }

    // While the drive is off nothing moves, and a pause is none. It does not replace another error that stays.
    for (drive_on, task_cycle_ns, error_id) in [(false, 0, 0), (true, 1, 1)] {
        let mut block = turning();
        (block.inputs.drive_on, block.inputs.task_cycle_ns, block.inputs.cycle_counter) =
            (drive_on, task_cycle_ns, 200);
        block.call();
        block.inputs.cycle_counter = 900;
        assert_eq!(block.call().error_id, error_id);
    }

    // One lost call is tolerated, without a step of its own.
    let mut block = turning();
    (block.inputs.x_command, block.inputs.cycle_counter) = (2000.0 * 191.0 % 360_000.0, 201);
    let outputs = block.call();
    assert_eq!((outputs.error_id, outputs.x_spindle, outputs.loop_closed), (0, block.inputs.x_command, true));
}
