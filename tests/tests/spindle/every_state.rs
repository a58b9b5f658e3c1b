//! What the drive, a wrong cycle and a reset do in every state.

use super::bench::{Bench, RPM, V_STEP};
use reference::spindle::{Job, SpindleState};

pub type Way = fn(Bench) -> Bench;

/// Ways to each of the five states, and to the start.
pub const STATES: [(SpindleState, Way); 6] = [
    (SpindleState::ToPosition, |bench| bench),
    (SpindleState::Position, Bench::turning),
    (SpindleState::ToVelocity, Bench::before_to_velocity),
    (SpindleState::Velocity, |bench| bench.fast(1000.0 * RPM)),
    (SpindleState::Brake, |bench| bench.before_brake(1000.0 * RPM)),
    (SpindleState::ToPosition, Bench::before_to_position),
];

#[test]
fn drive_off_leads_to_to_position_on_the_actual_position_from_every_state() {
    for (_, state) in &STATES[1..] {
        for bench in Bench::both() {
            let mut bench = state(bench);
            (bench.x_actual, bench.v_actual) = (Some(-1.0), Some(0.0));
            let o = bench.with_inputs(|i| i.drive_on = false);
            assert_eq!((o.spindle_state, o.x_spindle, o.v_spindle), (SpindleState::ToPosition, 359_999.0, 0.0));
            assert_eq!((o.operation_mode, o.job, o.error_id), (bench.coeffs.position_mode, Job::Stop, 0));
            bench.x_actual = Some(5.0);
            let o = bench.cycle();
            assert_eq!((o.spindle_state, o.x_spindle, o.error_id), (SpindleState::ToPosition, 5.0, 0));
        }
    }
}

#[test]
fn a_reset_clears_what_waits_and_makes_stop_the_job_in_its_cycle() {
    for (_, state) in &STATES[1..] {
        for bench in Bench::both() {
            let o = state(bench).with_inputs(|i| (i.reset, i.job_done) = (true, true));
            assert_eq!((o.waiting, o.job, o.job_speed, o.job_position), (0, Job::Stop, 0.0, 0.0));
        }
    }
}

#[test]
fn a_wrong_cycle_is_error_1_which_stays_and_stops_in_every_state() {
    for (state, at) in STATES {
        for bench in Bench::both() {
            let mut bench = at(bench);
            let old = bench.outputs;
            let o = bench.with_inputs(|i| i.task_cycle_ns = 1_000_000);
            assert_eq!((o.error_id, o.spindle_state, o.job, o.loop_closed), (1, state, Job::Stop, false));
            assert_eq!((o.v_spindle, o.operation_mode), ((old.v_spindle - V_STEP).max(0.0), old.operation_mode));
            let o = bench.cycles(200);
            assert_eq!((o.error_id, o.spindle_state, o.v_spindle), (1, state, 0.0), "it stays");
            let o = bench.with_inputs(|i| i.reset = true);
            assert_eq!((o.error_id, o.spindle_state), (0, SpindleState::Brake));
        }
    }
}

#[test]
fn a_wrong_cycle_with_the_drive_off_is_error_1_which_stays_in_every_state() {
    for (_, at) in STATES {
        for bench in Bench::both() {
            let mut bench = at(bench);
            bench.v_actual = Some(0.0);
            let o = bench.with_inputs(|i| (i.task_cycle_ns, i.drive_on) = (1_000_000, false));
            assert_eq!((o.error_id, o.spindle_state, o.v_spindle), (1, SpindleState::ToPosition, 0.0));
            assert_eq!(bench.with_inputs(|i| i.drive_on = false).error_id, 1);
            assert_eq!(bench.cycle().error_id, 1);
        }
    }
}
