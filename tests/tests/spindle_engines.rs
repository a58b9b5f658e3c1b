//! Random requests, drives and interpolators through every engine: the same bits, of the changeover and of the whole axis of a spindle.

use axgen_tests::engines::agree;
use axgen_tests::environment::by_depth;
use axgen_tests::model::spindle::{Inputs, Parameters, history};
use axgen_tests::model::subject;
use axgen_tests::random::rng::Rng;
use generator::blocks::{Designed, blocks};
use golden::engine::{self, Engine};
use golden::samples::{Samples, Shape};
use portable::{Literal, Real, RealKind};
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// Cycles of a history; then the drive is off for a while.
const CYCLES: usize = 2000;

/// A spindle in the drive, in the CNC with all that an axis has, and one whose drive has velocity control alone.
const SPINDLES: [&str; 3] = [
    "kenngr.antr_typ = 'SERCOS'
antr.sercos.op_mode_for_velocity_control = 1
antr.nbr_delay_cycles = 4
antr.sai_op_mode_change.feed_forward_v_weighting = 500
process_data.additive_velocity = 'INT32'
process_data.velocity_command = 'INT16'
vorsteuer.vorsteuerung = 'ADD_VEL'
",
    "kenngr.antr_typ = 'SERCOS'
antr.sercos.op_mode_for_velocity_control = 1
antr.sai_op_mode_change = { v_velocity_control_on = 0, v_position_control_on = 0 }
",
    "vorsteuer.vorsteuerung = 'VEL'
lr_param.improved_position_control.enable = 'ON'
lr_param.improved_position_control.v_add_max_fact = 100
lr_param.improved_position_control.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }] }]
",
];

fn spindle(of: &str, real: RealKind) -> Designed {
    let real = match real {
        RealKind::F64 => "f64",
        RealKind::F32 => "f32",
    };
    let changeover = "antr.sai_op_mode_change.v_velocity_control_on = 1200000
antr.sai_op_mode_change.v_position_control_on = 300000
";
    let changeover = if of.contains("v_velocity_control_on") { "" } else { changeover };
    let shared = "spindle.brake_timeout = '1s'
spindle.mode_timeout = '20ms'
spindle.deceleration = 18000000.0
getriebe = [{ kv = 2000, dynamik = { vb_max = 18000000 }, multi_gain_z = 10000000, multi_gain_n = 360 }]
";
    subject::read(&format!(
        "cycle_time = '2ms'\n[axis.X]\nreal = '{real}'\nkenngr.achs_typ = 'ACHSTYP_SPINDEL'\n{changeover}{shared}{of}"
    ))
}

/// What the model's interpolators and drives have to know of the spindle.
fn parameters(designed: &Designed) -> Parameters {
    let coeffs = designed.spindle;
    Parameters {
        in_cnc: !coeffs.in_drive,
        only_velocity: coeffs.only_velocity,
        position_mode: coeffs.position_mode,
        velocity_mode: coeffs.velocity_mode,
        mode_timeout_cycles: coeffs.mode_cycles,
        brake_timeout_cycles: coeffs.brake_cycles,
        v_on: coeffs.v_velocity_control_on,
        v_off: coeffs.v_position_control_on,
        window: coeffs.window,
        cycle: coeffs.cycle_time,
        cycle_ns: coeffs.cycle_time_ns,
        deceleration: coeffs.v_step / coeffs.cycle_time,
        takeover_window: coeffs.takeover_window,
        takeover_way: coeffs.takeover_way,
        ..Parameters::example()
    }
}

/// The signal of that name.
fn signal(name: &str, of: &Inputs) -> Option<Literal> {
    Some(match name {
        "x_command" => Literal::F64(of.x_command),
        "v_interpolator" => Literal::F64(of.v_interpolator),
        "x_actual" => Literal::F64(of.x_actual),
        "v_actual" | "v_motor" => Literal::F64(of.v_actual),
        "s_word" => Literal::F64(of.s_word),
        "s_position" => Literal::F64(of.s_position),
        "m3" => Literal::Bool(of.m3),
        "m4" => Literal::Bool(of.m4),
        "m5" => Literal::Bool(of.m5),
        "m19" => Literal::Bool(of.m19),
        "putax" => Literal::Bool(of.putax),
        "g74" => Literal::Bool(of.g74),
        "job_done" => Literal::Bool(of.job_done),
        "drive_on" => Literal::Bool(of.drive_on),
        "operation_mode_display" => Literal::I32(of.operation_mode_display),
        "feedforward_active" => Literal::Bool(of.feedforward_active),
        "feedforward_percentage" => Literal::I32(of.feedforward_percentage),
        "reset" => Literal::Bool(of.reset),
        "task_cycle_ns" => Literal::U32(of.task_cycle_ns),
        _ => return None,
    })
}

/// Requests and answers without a machine after them: every few cycles something new.
fn crowd(seed: u64, p: &Parameters) -> Vec<Inputs> {
    let mut rng = Rng::new(seed);
    let mut inputs = Inputs { drive_on: true, ..Inputs::START };
    let fast = p.v_on.max(p.deceleration * p.cycle);
    let velocities = [0.0, p.v_off, -p.v_off, fast, -fast, 2.0 * fast, -2.0 * fast];
    let cycle = |_| {
        for request in
            [&mut inputs.m3, &mut inputs.m4, &mut inputs.m5, &mut inputs.m19, &mut inputs.putax, &mut inputs.g74]
        {
            *request = rng.chance(15);
        }
        inputs.reset = rng.chance(2);
        inputs.drive_on = !rng.chance(1);
        inputs.job_done = rng.chance(50);
        inputs.task_cycle_ns = if rng.chance(1) { 1 } else { 0 };
        inputs.s_word = *rng.pick(&velocities);
        if rng.chance(20) {
            inputs.v_interpolator = *rng.pick(&velocities);
            inputs.v_actual = *rng.pick(&velocities);
            inputs.operation_mode_display = *rng.pick(&[p.position_mode, p.velocity_mode]);
            inputs.x_actual = *rng.pick(&[0.0, 90_000.0, -1.0, 360_000.0]);
        }
        inputs.x_command = inputs.x_actual + inputs.v_interpolator * p.cycle;
        inputs
    };
    (0..CYCLES).map(cycle).collect()
}

/// The inputs of a block, history after history.
fn samples(shape: Shape, p: &Parameters, cycles: usize) -> Samples {
    let mut samples = Samples::with_capacity(shape, cycles);
    for seed in 0..cycles.div_ceil(CYCLES) as u64 {
        // A machine's histories, and requests so close together that no machine would follow.
        let inputs = if seed.is_multiple_of(2) { history(seed, CYCLES, p) } else { crowd(seed, p) };
        for inputs in inputs {
            let value = |(name, start): (&String, Literal)| match (signal(name, &inputs).unwrap_or(start), start) {
                (Literal::F64(wide), Literal::F32(_)) => Literal::F32(f32::lit(wide)),
                (value, _) => value,
            };
            let signals = samples.shape.signals.iter().map(|signal| (&signal.name, signal.start));
            let values: Vec<Literal> = signals.map(value).collect();
            samples.push(&values);
        }
    }
    samples
}

#[test]
fn random_requests_give_the_same_bits_in_every_engine() {
    let given = std::env::var("AXGEN_SPINDLE_CYCLES").ok().and_then(|text| text.parse().ok());
    let cycles: usize = given.unwrap_or(by_depth(28_000, 40_000, 216_000));
    let all: Vec<Designed> =
        SPINDLES.iter().flat_map(|of| [RealKind::F64, RealKind::F32].map(|real| spindle(of, real))).collect();
    let requests = AtomicU64::new(0);
    all.par_iter().for_each(|designed| {
        let p = parameters(designed);
        for block in blocks(designed).unwrap().iter().filter(|block| block.program.block.starts_with("spindle")) {
            let name = format!("{} in {:?}", block.program.block, block.program.real);
            let inputs = samples(Shape::of(&block.program.inputs, block.program.real), &p, cycles);
            let expected = engine::run(Engine::Reference, designed, block, &inputs).unwrap();
            visits_everything(&name, &expected, p.only_velocity);
            requests.fetch_add(counted(&inputs), Ordering::Relaxed);
            agree(&name, designed, block, &inputs, &expected);
        }
    });
    let requests = requests.into_inner();
    eprintln!("{requests} requests");
    assert!(requests > 2 * cycles as u64, "{requests} in 12 runs of {cycles} cycles");
}

/// How many requests there are: inputs that become TRUE.
fn counted(inputs: &Samples) -> u64 {
    let is_request = |name: &str| ["m3", "m4", "m5", "m19", "putax", "g74"].contains(&name);
    let at: Vec<usize> =
        inputs.shape.signals.iter().enumerate().filter(|(_, of)| is_request(&of.name)).map(|(at, _)| at).collect();
    let (mut values, mut before, mut count) = (Vec::new(), vec![Literal::Bool(true); at.len()], 0);
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut values);
        for (at, before) in at.iter().zip(&mut before) {
            count += u64::from(values[*at] == Literal::Bool(true) && *before == Literal::Bool(false));
            *before = values[*at];
        }
    }
    count
}

/// All states that the spindle has, and errors that stay.
fn visits_everything(block: &str, outputs: &Samples, only_velocity: bool) {
    let position = |name: &str| {
        outputs.shape.signals.iter().position(|signal| signal.name == name).expect("the block has the output")
    };
    let (state, error) = (position("spindle_state"), position("error_id"));
    let (mut values, mut states, mut errors) = (Vec::new(), [0; 5], 0);
    for sample in 0..outputs.len() {
        outputs.read(sample, &mut values);
        if let (Literal::I32(of), Literal::U32(id)) = (values[state], values[error]) {
            states[usize::try_from(of).expect("a state")] += 1;
            errors += usize::from(id > 40);
        }
    }
    eprintln!("{block}: cycles in each state {states:?}, with an error that stays {errors}");
    assert!(states.iter().skip(if only_velocity { 2 } else { 0 }).all(|cycles| *cycles > 0) && errors > 100);
}
