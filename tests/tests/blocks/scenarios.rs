//! What the recorded scenarios of the manual's examples show: the numbers of the manual, in the samples that were kept.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![expect(clippy::float_cmp, reason = "the speeds of a program are reached exactly")]

use golden::samples::{Samples, Shape};
use golden::{case, csv};
use portable::Literal;
use std::path::Path;

const RPM: f64 = 6000.0;
const VON: f64 = 200.0 * RPM;

const POSITION: i32 = 0;
const BRAKE: i32 = 3;
/// From rest: at first TO_POSITION, then up to velocity control and back.
const WHOLE_WAY: [i32; 7] = [4, 0, 1, 2, 3, 4, 0];

/// One cycle of a recorded scenario.
#[derive(Clone, Copy, Debug)]
struct Cycle {
    state: i32,
    x: f64,
    v: f64,
    x_actual: f64,
    v_actual: f64,
    x_command: f64,
    job_done: bool,
    m19: bool,
}

/// The cycles that a case has recorded.
fn cycles(name: &str) -> Vec<Cycle> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden/cases").join(name);
    let case = case::read(&folder).unwrap();
    let (real, program) = (case.axis.axis.real, &case.block.program);
    let read = |file: &str, shape: &Shape| csv::read(&std::fs::read_to_string(folder.join(file)).unwrap(), shape);
    let inputs = read("inputs.csv", &Shape::of(&program.inputs, real)).unwrap();
    let outputs = read("outputs.csv", &Shape::of(&program.outputs, real)).unwrap();
    assert!((800..2500).contains(&inputs.len()) && inputs.len() == outputs.len(), "{name}: {} samples", inputs.len());
    let cycle = |sample| {
        let value = |run: &Samples, name: &str| {
            let mut values = Vec::new();
            run.read(sample, &mut values);
            values[run.shape.signals.iter().position(|signal| signal.name == name).unwrap()]
        };
        let real = |run, name| match value(run, name) {
            Literal::F64(value) => value,
            other => panic!("{name}: {other:?}"),
        };
        let Literal::I32(state) = value(&outputs, "spindle_state") else { panic!("spindle_state") };
        Cycle {
            state,
            x: real(&outputs, "x_spindle"),
            v: real(&outputs, "v_spindle"),
            x_actual: real(&inputs, "x_actual"),
            v_actual: real(&inputs, "v_actual"),
            x_command: real(&inputs, "x_command"),
            job_done: value(&inputs, "job_done") == Literal::Bool(true),
            m19: value(&inputs, "m19") == Literal::Bool(true),
        }
    };
    (0..inputs.len()).map(cycle).collect()
}

fn states(cycles: &[Cycle]) -> Vec<i32> {
    let mut states: Vec<i32> = cycles.iter().map(|cycle| cycle.state).collect();
    states.dedup();
    states
}

/// The cycles from the last change to position control on.
fn positioning(cycles: &[Cycle]) -> &[Cycle] {
    let before = cycles.iter().rposition(|cycle| cycle.state != POSITION).unwrap();
    &cycles[before + 1..]
}

fn largest(cycles: &[Cycle], sign: f64) -> f64 {
    cycles.iter().fold(0.0, |largest, cycle| f64::max(largest, sign * cycle.v))
}

/// Stands at 180 deg: the command on it, the actual position within 0.1 deg.
fn stands(cycle: &Cycle) {
    assert!(cycle.job_done && cycle.state == POSITION, "{cycle:?}");
    assert_eq!([cycle.x, cycle.v], [180_000.0, 0.0]);
    assert!((cycle.x_actual - 180_000.0).abs() <= 100.0, "{cycle:?}");
}

/// From velocity control over Voff to position control: no jump of the drive's position, and none where the
/// interpolator takes over.
fn changes_at(cycles: &[Cycle], off: f64, settled: f64, lead_time: f64) {
    let last = cycles.iter().rposition(|cycle| cycle.state == BRAKE).unwrap();
    let (left, entered) = (cycles[last], cycles[last + 1]);
    assert_eq!(left.v, off);
    assert!(left.v_actual.abs() <= settled, "{left:?}");
    // The formula of the page, bit by bit.
    let position = (left.x_actual + off * lead_time).rem_euclid(360_000.0);
    assert_eq!(entered.x.to_bits(), position.to_bits(), "{} and {position}", entered.x);
    let first = positioning(cycles)[0];
    let before = cycles[cycles.len() - positioning(cycles).len() - 1];
    let cycle_time = if off < 0.0 { 1e-3 } else { 2e-3 };
    // 0.01 deg: the grid, and what the jerk makes of a cycle.
    let step = (first.x_command - (before.x + before.v * cycle_time)).rem_euclid(360_000.0);
    assert!(step.min(360_000.0 - step) < 10.0, "the interpolator moves on from there: {step}");
}

#[test]
fn figure_1_brakes_to_50_rpm_changes_and_turns_round() {
    let cycles = cycles("spindle-positioning-with-reversal");
    assert_eq!(states(&cycles), WHOLE_WAY);
    assert_eq!(largest(&cycles, 1.0), 1000.0 * RPM);
    changes_at(&cycles, 50.0 * RPM, 51.0 * RPM, 0.035);
    let positioning = positioning(&cycles);
    assert!(positioning[0].v > 49.0 * RPM, "it comes in the direction of M3");
    assert_eq!(largest(positioning, -1.0), 50.0 * RPM, "M4 S50");
    stands(cycles.last().unwrap());
}

#[test]
fn figure_2_positions_with_500_rpm_although_velocity_control_begins_at_200_rpm() {
    let cycles = cycles("spindle-positioning-above-the-changeover-speed");
    assert_eq!(states(&cycles), WHOLE_WAY);
    assert_eq!(largest(&cycles, -1.0), 1000.0 * RPM);
    assert_eq!(largest(&cycles, 1.0), 0.0, "M4 only");
    changes_at(&cycles, -100.0 * RPM, 101.0 * RPM, 5.0 * 1e-3 + 0.025);
    assert_eq!(largest(positioning(&cycles), -1.0), 500.0 * RPM);
    stands(cycles.last().unwrap());
}

#[test]
fn the_program_of_six_blocks_never_leaves_position_control() {
    let cycles = cycles("spindle-changeover-program");
    assert_eq!(states(&cycles), [4, POSITION]);
    let requested: Vec<usize> = (0..cycles.len()).filter(|sample| cycles[*sample].m19).collect();
    assert_eq!(requested.len(), 3);
    for (block, from) in requested.iter().enumerate() {
        let before = &cycles[..*from];
        assert_eq!(before.last().unwrap().v.abs(), VON, "S200 is not above Von");
        let to = requested.get(block + 1).copied().unwrap_or(cycles.len());
        let done = cycles[*from..to].iter().find(|cycle| cycle.job_done).unwrap();
        stands(done);
    }
    assert!(largest(&cycles, 1.0) > VON && largest(&cycles, -1.0) > VON, "M19 turns faster than Von");
}

#[test]
fn position_control_in_the_cnc_changes_within_a_cycle() {
    let cycles = cycles("spindle-in-the-cnc");
    assert_eq!(states(&cycles), [4, 0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 0]);
    let changing = |state| cycles.iter().filter(|cycle| cycle.state == state).count();
    // TO_VELOCITY twice, TO_POSITION twice and three cycles at the start.
    assert_eq!([changing(1), changing(4)], [2, 5]);
}
