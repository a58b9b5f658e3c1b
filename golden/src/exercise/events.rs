//! The part of an exercise that does not react to the block: moves, vibrations, noise, and events.

use super::boundaries;
use crate::stimulus::{Component, Event, Stimulus, Window};
use crate::waveform::Form;
use compiler::program::Program;
use generator::axis::{Axis, Excitation, Filter};
use portable::Extreme;

/// The first cycle of the events at boundaries of process data: early, so that a short run contains them.
const FIRST_BOUNDARY: u64 = 200;

/// All events of a block: moves, vibrations at its own frequencies, noise, steps to the limit, mode changes, resets, loss of
/// position control, bad samples, wrong cycle times, rest, and both boundaries of process data. A block gets those for which
/// it has a signal.
pub(super) fn stimulus(axis: &Axis, block: &Program) -> Stimulus {
    let has = |name: &str| block.inputs.iter().any(|input| input.path == name);
    let signal = reals(axis).into_iter().zip(1..).filter(|((name, _), _)| has(name));
    let signal = signal.map(|((name, largest), seed)| (name.to_owned(), components(axis, seed, largest))).collect();
    let events = EVENTS.into_iter().filter(|(signal, ..)| has(signal));
    let mut event: Vec<Event> =
        events.map(|(signal, value, at, length, every)| Event::new(signal, value, at, length, every)).collect();
    event.extend(
        axis.excitation.iter().filter(|_| has("hold_to_run")).flat_map(excited).filter(|event| has(&event.signal)),
    );
    event.extend(boundaries::events(block, axis.real, FIRST_BOUNDARY));
    Stimulus { signal, event }
}

/// The real inputs of all blocks, each with its size at the largest velocity of the axis.
fn reals(axis: &Axis) -> [(&'static str, f64); 13] {
    let v_max = axis.ipc.v_max;
    [
        ("v_command", v_max),
        ("v_motor", v_max),
        ("v_direct", v_max),
        ("v_interpolator", v_max),
        ("a_interpolator", 10.0 * v_max),
        ("j_interpolator", 300.0 * v_max),
        ("x_command", 2.0 * v_max),
        ("x_actual", 1.98 * v_max),
        ("following_error", 0.02 * v_max),
        ("v_feedforward", v_max),
        ("v_additive", v_max),
        ("v_add", 0.1 * v_max),
        ("v_add_master", 0.1 * v_max),
    ]
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number of cycles within 8000")]
fn components(axis: &Axis, seed: u32, v_max: f64) -> Vec<Component> {
    let moving = Window { at: 0, length: 60_000, every: 80_000 };
    let part = |form, share: f64, window| Component { form, amplitude: share * v_max, window };
    let mut components = vec![
        part(Form::Move { phase: 5_000, ramp: 500 }, 1.0, moving),
        part(Form::Noise { seed }, 0.01, moving),
        part(Form::Chirp { from: 2_000.0, to: 2.5, length: 20_000.0 }, 0.05, moving),
        part(Form::Constant, 0.5, Window { at: 31_000, length: 2_000, every: 40_000 }),
    ];
    for stage in axis.ipc.stage.iter().flatten() {
        // Large enough for the stage alone to reach the limit.
        let large = (1.5 * axis.ipc.limit() / stage.weight() / axis.ipc.v_max).smaller(2.0);
        for filter in stage.filter {
            if let Filter::Bandpass { f0, .. } = filter {
                let period = 1.0 / (f0 * axis.cycle_time());
                let sine = Form::Sine { period };
                let length = (8.0 * period).clamp(1_500.0, 8_000.0) as u64;
                components.push(part(sine.clone(), 0.1, moving));
                components.push(part(sine, large, Window { at: 42_000, length, every: 50_000 }));
            }
        }
    }
    components
}

/// A run to its end, if the samples suffice, between short ones; the motor turns round, stands, and sends bad samples.
fn excited(of: &Excitation) -> Vec<Event> {
    let speed = format!("{}", 4.0 * of.amplitude);
    let whole = (of.periods as u64 + 1) * of.sequence.period() as u64 + 3_000;
    let event = Event::new;
    vec![
        event("v_motor", &speed, 0, 0, 0),
        event("hold_to_run", "1", 20, 700, 1_000),
        event("v_motor", &format!("-{speed}"), 400, 400, 3_000),
        event("v_motor", "0", 2_010, 20, 5_000),
        event("v_motor", "nan", 2_300, 1, 7_000),
        event("position_controlled", "0", 1_200, 40, 3_000),
        event("task_cycle_ns", "1", 3_300, 2, 11_000),
        event("v_motor", &speed, 5_000, whole, 0),
        event("task_cycle_ns", "0", 5_000, whole, 0),
        event("position_controlled", "1", 5_000, whole, 0),
        event("cycle_counter", "counts+1", 5_000, whole, 0),
        event("hold_to_run", "0", 5_000, 2, 0),
        event("hold_to_run", "1", 5_002, whole, 0),
    ]
}

/// What a run does, block by block: signal, value, first sample, number of samples, period.
const EVENTS: [(&str, &str, u64, u64, u64); 46] = [
    ("mode", "1", 50, 0, 0),
    ("mode", "2", 12_000, 3_000, 25_000),
    ("mode", "0", 18_000, 1_000, 23_000),
    ("mode", "3", 27_000, 2, 29_000),
    ("position_controlled", "0", 21_000, 40, 31_000),
    ("reset", "1", 9_000, 30, 37_000),
    ("task_cycle_ns", "1", 33_000, 3, 41_000),
    ("cycle_counter", "counts+1", 0, 0, 0),
    ("cycle_counter", "counts+2", 600, 400, 1_000),
    ("cycle_counter", "counts+90", 3_300, 40, 7_000),
    ("cycle_counter", "counts*2", 4_500, 40, 9_000),
    ("cycle_counter", "counts/2", 7_500, 40, 11_000),
    ("cycle_counter", "counts*4/3", 8_400, 40, 13_000),
    ("cycle_counter", "0", 10_800, 20, 17_000),
    ("cycle_counter", "counts+4294956000", 11_100, 400, 19_000),
    ("v_command", "nan", 14_000, 1, 43_000),
    ("v_motor", "inf", 16_000, 2, 47_000),
    ("v_motor", "-1.5e15", 24_500, 1, 53_000),
    ("v_direct", "nan", 26_000, 1, 59_000),
    ("feedforward_active", "1", 100, 0, 0),
    ("feedforward_active", "0", 13_500, 2_000, 33_000),
    ("feedforward_percentage", "80", 5_000, 4_000, 27_000),
    ("feedforward_percentage", "0", 11_000, 500, 39_000),
    ("feedforward_percentage", "-3", 20_000, 50, 51_000),
    ("feedforward_percentage", "250", 22_000, 50, 51_000),
    ("torque_feedforward", "-1234", 2_000, 9_000, 21_000),
    ("v_interpolator", "nan", 15_000, 1, 44_000),
    ("a_interpolator", "-inf", 17_000, 2, 48_000),
    ("a_interpolator", "1e9", 36_000, 60, 61_000),
    ("j_interpolator", "2e15", 19_000, 1, 52_000),
    ("x_command", "nan", 23_000, 2, 54_000),
    ("x_command", "1e9", 38_000, 40, 63_000),
    ("x_actual", "inf", 25_000, 1, 56_000),
    ("following_error", "inf", 25_500, 1, 57_000),
    ("v_feedforward", "nan", 28_000, 1, 58_000),
    ("v_additive", "nan", 29_000, 1, 62_000),
    ("v_add", "nan", 31_500, 1, 64_000),
    ("v_add_master", "nan", 32_500, 1, 66_000),
    ("v_add_master", "-1e9", 39_000, 20, 67_000),
    ("tuning_weight[0]", "0.25", 1_500, 6_000, 17_000),
    ("tuning_weight[0]", "nan", 4_000, 3, 19_000),
    ("tuning_weight[1]", "0.7", 3_000, 5_000, 13_000),
    ("tuning_weight[1]", "1.0000001", 6_000, 40, 29_000),
    ("tuning_weight[2]", "0", 2_500, 7_000, 15_000),
    ("tuning_limit", "0.01", 7_000, 5_000, 18_000),
    ("tuning_limit", "-0.5", 10_500, 2, 22_000),
];
